// SPDX-License-Identifier: MIT
// Sliders of the formula, and the time.
#include <fmt/format.h>
#include <imgui.h>

#include "studio/panels.h"
#include "studio/slider.h"

namespace studio {
namespace {

void show_parameter(scene::Document& document, const field::Parameter& parameter) {
    const auto place = document.parameters.find(parameter.name);
    double value = place == document.parameters.end() ? parameter.initial : place->second;
    const bool whole = parameter.step && *parameter.step == static_cast<int>(*parameter.step);
    const SliderRange range{.minimum = parameter.minimum,
                            .maximum = parameter.maximum,
                            .initial = parameter.initial,
                            .step = parameter.step.value_or(0),
                            .format = whole ? "%.0f" : "%.4g"};
    const std::string label =
        (parameter.label.empty() ? parameter.name : parameter.label) + "##" + parameter.name;
    const std::string tooltip = fmt::format(
        "{} in [{}, {}], by default {}\nDouble-click for the default, Ctrl+click to "
        "type a number.",
        parameter.name, parameter.minimum, parameter.maximum, parameter.initial);
    if (!slider(label.c_str(), value, range, tooltip)) return;
    if (value == parameter.initial) {
        document.parameters.erase(parameter.name);
    } else {
        document.parameters[parameter.name] = value;
    }
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
    for (const field::Parameter& parameter : parameters) {
        show_parameter(workspace.document, parameter);
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
