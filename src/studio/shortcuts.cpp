// SPDX-License-Identifier: MIT
#include "studio/shortcuts.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "studio/actions.h"

namespace studio {
namespace {

bool pressed(int key) { return ImGui::IsKeyPressed(key, false); }

/// A field that is being edited has a copy of its text and would write it over the old value. The
/// formula's editor keeps the keyboard: it takes the new text (View::reload_formula).
void let_go_of_fields() {
    const ImGuiWindow* window = ImGui::GetCurrentContext()->ActiveIdWindow;
    const bool in_formula =
        window && std::string_view(window->RootWindow->Name) == std::string_view("Formula");
    if (!in_formula) ImGui::ClearActiveID();
}

void handle_undo(Workspace& workspace, bool redo) {
    let_go_of_fields();
    if (redo) {
        workspace.redo();
    } else {
        workspace.undo();
    }
}

void handle_commands(Workspace& workspace, bool shift) {
    if (ImGui::IsKeyPressed(GLFW_KEY_Z)) handle_undo(workspace, shift);
    if (ImGui::IsKeyPressed(GLFW_KEY_Y)) handle_undo(workspace, true);
    if (pressed(GLFW_KEY_S)) shift ? save_as(workspace) : save(workspace);
    if (pressed(GLFW_KEY_L)) workspace.view.focus_formula = workspace.view.panels = true;
    if (pressed(GLFW_KEY_O)) open_dialog(workspace);
    if (pressed(GLFW_KEY_N)) start(workspace, {PendingAction::Kind::new_document, {}});
    if (pressed(GLFW_KEY_Q)) start(workspace, {PendingAction::Kind::quit, {}});
}

}  // namespace

void handle_shortcuts(Workspace& workspace) {
    const ImGuiIO& io = ImGui::GetIO();
    if (workspace.dialogs.open()) return;
    if (pressed(GLFW_KEY_F1)) workspace.view.help = !workspace.view.help;
    if (pressed(GLFW_KEY_F5)) check_accuracy(workspace);
    if (pressed(GLFW_KEY_F11)) screenshot_dialog(workspace);
    if (pressed(GLFW_KEY_F12)) quick_screenshot(workspace);
    if (io.KeyCtrl && !io.KeyAlt) return handle_commands(workspace, io.KeyShift);
    if (io.WantTextInput || io.KeyAlt || ImGui::IsAnyItemActive()) return;
    if (pressed(GLFW_KEY_F)) frame_all(workspace);
    if (pressed(GLFW_KEY_SPACE)) workspace.play(!workspace.playback.playing);
    if (pressed(GLFW_KEY_TAB)) workspace.view.panels = !workspace.view.panels;
    if (pressed(GLFW_KEY_ESCAPE)) workspace.view.help = false;
}

}  // namespace studio
