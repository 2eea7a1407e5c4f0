// SPDX-License-Identifier: MIT
// The formula's parameters, and the time.
#include <algorithm>
#include <string>
#include <vector>

#include <imgui.h>

#include "compile/parameter_values.h"
#include "studio/panels.h"
#include "studio/parameter_control.h"
#include "studio/slider.h"

namespace studio {
namespace {

void show_parameter(scene::Document& document, const field::Parameter& parameter) {
    std::vector<double> components = compile::components_in(document, parameter);
    if (!parameter_control(parameter, components)) return;
    compile::set_components(document, parameter, components);
}

/// Those of one group; an empty name has those without a group.
void show_group(scene::Document& document, const std::vector<field::Parameter>& parameters,
                const std::string& group) {
    for (const field::Parameter& parameter : parameters) {
        if (parameter.group == group) show_parameter(document, parameter);
    }
}

/// Groups in the order in which they first appear.
std::vector<std::string> groups_of(const std::vector<field::Parameter>& parameters) {
    std::vector<std::string> groups;
    for (const field::Parameter& parameter : parameters) {
        const std::string& group = parameter.group;
        if (!group.empty() && std::ranges::find(groups, group) == groups.end()) {
            groups.push_back(group);
        }
    }
    return groups;
}

void show_time(Workspace& workspace) {
    Playback& playback = workspace.playback;
    double time = workspace.shown().time;
    if (number_field("Time t", time, 0.02, -1e6, 1e6,
                     "Seconds. The formula may use it as t; the picture is of this moment.")) {
        (playback.playing ? playback.time : workspace.document.time) = time;
    }
    label_on_the_left("");
    if (ImGui::Button(playback.playing ? "Pause" : "Play", ImVec2(70 * workspace.scale, 0))) {
        workspace.play(!playback.playing);
    }
    ImGui::SameLine();
    if (ImGui::Button("Reset", ImVec2(70 * workspace.scale, 0))) {
        playback.time = 0;
        workspace.document.time = 0;
    }
}

}  // namespace

void show_parameter_panel(Workspace& workspace) {
    const auto& parameters = workspace.compilation.parameters;
    show_group(workspace.document, parameters, "");
    for (const std::string& group : groups_of(parameters)) {
        if (ImGui::CollapsingHeader(group.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) {
            show_group(workspace.document, parameters, group);
        }
    }
    if (parameters.empty()) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextDisabled(
            "The formula has no parameters. A line such as  param a = 0.5 in [0, 2]  before the "
            "equation makes a slider.");
        ImGui::PopTextWrapPos();
    } else if (ImGui::Button("All to their defaults")) {
        workspace.document.parameters.clear();
    }
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
    show_time(workspace);
}

}  // namespace studio
