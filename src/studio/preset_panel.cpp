// SPDX-License-Identifier: MIT
// The lists of presets.
#include <algorithm>
#include <cctype>
#include <string>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "studio/actions.h"
#include "studio/panels.h"
#include "studio/slider.h"

namespace studio {
namespace {

std::string in_lower_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

bool matches(const PresetEntry& entry, const std::string& filter) {
    const std::string wanted = in_lower_case(filter);
    return in_lower_case(entry.title + ' ' + entry.folder + ' ' + entry.file.stem().string())
               .find(wanted) != std::string::npos;
}

void show_entry(Workspace& workspace, const PresetEntry& entry) {
    const bool open = workspace.file && *workspace.file == entry.file;
    const std::string label =
        entry.title + (open && workspace.unsaved() ? " *" : "") + "###" + entry.file.string();
    ImGui::BeginDisabled(!entry.problem.empty());
    if (ImGui::Selectable(label.c_str(), open)) {
        start(workspace, {PendingAction::Kind::open, entry.file});
    }
    ImGui::EndDisabled();
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    const std::string text =
        entry.file.string() + (entry.problem.empty() ? "" : "\n" + entry.problem);
    ImGui::SetTooltip("%s", text.c_str());
}

void show_list(Workspace& workspace, const std::vector<PresetEntry>& list) {
    const std::string& filter = workspace.view.preset_filter;
    for (auto entry = list.begin(); entry != list.end();) {
        const auto end = std::find_if(entry, list.end(), [&](const PresetEntry& other) {
            return other.folder != entry->folder;
        });
        const bool any =
            std::any_of(entry, end, [&](const PresetEntry& e) { return matches(e, filter); });
        const bool bare = entry->folder.empty();
        if (any && !filter.empty()) ImGui::SetNextItemOpen(true);
        const bool shown =
            any && (bare || ImGui::TreeNodeEx(entry->folder.c_str(),
                                              ImGuiTreeNodeFlags_DefaultOpen |
                                                  ImGuiTreeNodeFlags_SpanAvailWidth));
        for (; entry != end; ++entry) {
            if (shown && matches(*entry, filter)) show_entry(workspace, *entry);
        }
        if (shown && !bare) ImGui::TreePop();
    }
}

void show_heading(const char* text) {
    ImGui::Spacing();
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.42f, 0.76f, 0.82f, 1));
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
    ImGui::Separator();
}

}  // namespace

void show_preset_panel(Workspace& workspace) {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##filter", "Search", &workspace.view.preset_filter);
    ImGui::BeginChild("lists");
    show_heading("My presets");
    if (workspace.presets.own.empty()) ImGui::TextDisabled("none yet");
    show_list(workspace, workspace.presets.own);
    show_heading("Shipped presets");
    if (workspace.presets.shipped.empty()) ImGui::TextDisabled("none found");
    show_list(workspace, workspace.presets.shipped);
    ImGui::Spacing();
    if (ImGui::SmallButton("Refresh")) workspace.presets = list_all_presets();
    ImGui::EndChild();
}

}  // namespace studio
