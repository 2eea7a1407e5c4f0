// SPDX-License-Identifier: MIT
// The list of keys and mouse actions.
#include <imgui.h>

#include "studio/panels.h"

namespace studio {
namespace {

struct Key {
    const char* keys;
    const char* what;
};

constexpr Key keys[] = {
    {"Ctrl+L", "go to the formula"},
    {"Ctrl+Z", "undo"},
    {"Ctrl+Shift+Z, Ctrl+Y", "redo"},
    {"Ctrl+N", "new document"},
    {"Ctrl+O", "open a file"},
    {"Ctrl+S", "save"},
    {"Ctrl+Shift+S", "save under another name"},
    {"Ctrl+Q", "quit"},
    {"F", "frame all: the whole region fills the picture"},
    {"Space", "start and stop the time t"},
    {"Tab", "hide and show the panels"},
    {"F1", "this list"},
    {"F5", "check the picture's accuracy"},
    {"F11", "picture dialog: size and place of a PNG"},
    {"F12", "picture at once, in the size that was used last"},
    {"Escape", "leave a field or a dialog"},
};

constexpr Key mouse[] = {
    {"left drag", "turn around the target"},
    {"right or middle drag, Shift+left", "move along the picture"},
    {"wheel", "come nearer, go away"},
    {"double-click on a slider", "back to its default"},
    {"Ctrl+click on a slider", "type a number"},
    {"right-click on a colour, a list or a box", "back to its default"},
};

template <std::size_t Count>
void show_table(const char* id, const Key (&rows)[Count], float width) {
    if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, width);
    for (const Key& row : rows) {
        ImGui::TableNextColumn();
        ImGui::TextColored(ImVec4(0.42f, 0.76f, 0.82f, 1), "%s", row.keys);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(row.what);
    }
    ImGui::EndTable();
}

}  // namespace

void show_help(Workspace& workspace) {
    if (!workspace.view.help) return;
    const ImVec2 centre = ImGui::GetMainViewport()->GetCenter();
    ImGui::SetNextWindowPos(centre, ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse;
    if (ImGui::Begin("Help", &workspace.view.help, flags)) {
        const float width = 240 * workspace.scale;
        ImGui::TextDisabled("Keys");
        show_table("keys", keys, width);
        ImGui::Spacing();
        ImGui::TextDisabled("Mouse");
        show_table("mouse", mouse, width);
        ImGui::Spacing();
        ImGui::TextDisabled("A formula");
        ImGui::PushFont(workspace.monospaced);
        ImGui::TextUnformatted(
            "param a = 1 in [0.5, 2] \"width\"\n"
            "(x/a)^2 + y^2 + z^2 = 1");
        ImGui::PopFont();
    }
    ImGui::End();
}

}  // namespace studio
