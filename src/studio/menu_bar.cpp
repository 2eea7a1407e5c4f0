// SPDX-License-Identifier: MIT
// The menus.
#include <imgui.h>

#include "studio/actions.h"
#include "studio/panels.h"

namespace studio {
namespace {

void show_file_menu(Workspace& workspace) {
    if (!ImGui::BeginMenu("File")) return;
    if (ImGui::MenuItem("New", "Ctrl+N")) start(workspace, {PendingAction::Kind::new_document, {}});
    if (ImGui::MenuItem("Open...", "Ctrl+O")) open_dialog(workspace);
    ImGui::Separator();
    if (ImGui::MenuItem("Save", "Ctrl+S")) save(workspace);
    if (ImGui::MenuItem("Save as...", "Ctrl+Shift+S")) save_as(workspace);
    ImGui::Separator();
    if (ImGui::MenuItem("Screenshot...", "F11")) screenshot_dialog(workspace);
    if (ImGui::MenuItem("Quick screenshot", "F12")) quick_screenshot(workspace);
    ImGui::Separator();
    if (ImGui::MenuItem("Quit", "Ctrl+Q")) start(workspace, {PendingAction::Kind::quit, {}});
    ImGui::EndMenu();
}

void show_edit_menu(Workspace& workspace) {
    if (!ImGui::BeginMenu("Edit")) return;
    if (ImGui::MenuItem("Undo", "Ctrl+Z", false, workspace.history.can_undo())) workspace.undo();
    if (ImGui::MenuItem("Redo", "Ctrl+Shift+Z", false, workspace.history.can_redo())) {
        workspace.redo();
    }
    ImGui::Separator();
    if (ImGui::MenuItem("Formula", "Ctrl+L")) workspace.view.focus_formula = true;
    ImGui::EndMenu();
}

void show_view_menu(Workspace& workspace) {
    if (!ImGui::BeginMenu("View")) return;
    if (ImGui::MenuItem("Frame all", "F")) frame_all(workspace);
    if (ImGui::MenuItem("Default view")) workspace.document.camera.reset();
    if (ImGui::MenuItem("Check accuracy", "F5", false, !workspace.playback.playing)) {
        check_accuracy(workspace);
    }
    ImGui::Separator();
    ImGui::MenuItem("Show step count", nullptr, &workspace.document.settings.show_steps);
    ImGui::MenuItem("Show what is proven", nullptr, &workspace.document.settings.show_certificate);
    ImGui::MenuItem("Ground grid", nullptr, &workspace.document.settings.grid);
    ImGui::Separator();
    ImGui::MenuItem("Panels", "Tab", &workspace.view.panels);
    ImGui::MenuItem("Presets", nullptr, &workspace.view.presets);
    ImGui::MenuItem("Accuracy", nullptr, &workspace.view.accuracy);
    ImGui::MenuItem("Messages", nullptr, &workspace.view.log);
    ImGui::EndMenu();
}

}  // namespace

void show_menu_bar(Workspace& workspace) {
    if (!ImGui::BeginMainMenuBar()) return;
    show_file_menu(workspace);
    show_edit_menu(workspace);
    show_view_menu(workspace);
    if (ImGui::BeginMenu("Help")) {
        ImGui::MenuItem("Keys and mouse", "F1", &workspace.view.help);
        ImGui::EndMenu();
    }
    ImGui::SameLine(0, 24);
    const std::string title = workspace.name() + (workspace.unsaved() ? " *" : "");
    ImGui::TextDisabled("%s", title.c_str());
    ImGui::EndMainMenuBar();
}

}  // namespace studio
