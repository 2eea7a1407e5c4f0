// SPDX-License-Identifier: MIT
// The line at the bottom: how the last full picture went, and on what.
#include <fmt/format.h>
#include <imgui.h>

#include "studio/panels.h"
#include "studio/slider.h"

namespace studio {
namespace {

void separator() {
    ImGui::SameLine(0, 12);
    ImGui::TextDisabled("|");
    ImGui::SameLine(0, 12);
}

void show_precision(const compile::PrecisionChoice& choice) {
    ImGui::TextUnformatted(std::string(shader::name_of(choice.precision)).c_str());
    tooltip_of_last(
        fmt::format("The numbers that the picture is calculated in: {}.", choice.reason));
    separator();
}

void show_report(const PictureReport& report) {
    const PictureStatistics& statistics = report.statistics;
    ImGui::TextUnformatted(fmt::format("{:.1f} ms", report.seconds * 1000).c_str());
    tooltip_of_last("Drawing time of the last full picture");
    separator();
    ImGui::TextUnformatted(fmt::format("{} x {}", report.width, report.height).c_str());
    separator();
    ImGui::TextUnformatted(
        fmt::format("steps: mean {:.1f}, most {}", statistics.mean_steps, statistics.most_steps)
            .c_str());
    tooltip_of_last("Steps of the primary rays");
    separator();
    const std::string out = fmt::format("{} pixels out of steps", statistics.unresolved);
    if (statistics.unresolved == 0) {
        ImGui::TextUnformatted(out.c_str());
    } else {
        ImGui::TextColored(ImVec4(0.91f, 0.75f, 0.35f, 1), "%s", out.c_str());
        tooltip_of_last("Their rays reached the limit of steps; raise it in the tab Render.");
    }
}

/// By what right the picture is right.
void show_steps(const Workspace& workspace) {
    separator();
    const ImVec4 doubtful(0.91f, 0.75f, 0.35f, 1);
    if (workspace.document.settings.lipschitz >= 1) {
        ImGui::TextUnformatted(workspace.compilation.steps.c_str());
        tooltip_of_last(
            "How the steps of the rays are found. View, Show what is proven colours it.");
        return;
    }
    const std::optional<std::size_t>& at_risk = workspace.report->at_risk;
    const std::string text = at_risk ? fmt::format("not certified: {} pixels at risk", *at_risk)
                                     : std::string("not certified");
    ImGui::TextColored(doubtful, "%s", text.c_str());
    tooltip_of_last(
        "With a Lipschitz scale below 1 steps are longer than they are proven to be: surfaces may "
        "be passed on so many rays.");
}

}  // namespace

void show_status_bar(const Workspace& workspace) {
    const char* state = workspace.drawing_still          ? "drawing a picture..."
                        : workspace.compilation.busy     ? "compiling..."
                        : !workspace.picture_complete    ? "drawing..."
                        : workspace.compilation.drawable ? "ready"
                                                         : "no picture";
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(state);
    ImGui::SameLine(150 * workspace.scale);
    if (workspace.report) {
        show_precision(workspace.compilation.precision);
        show_report(*workspace.report);
        show_steps(workspace);
    }
    const float width = ImGui::CalcTextSize(workspace.renderer.c_str()).x;
    const float place = ImGui::GetWindowWidth() - width - ImGui::GetStyle().WindowPadding.x;
    ImGui::SameLine();
    if (place > ImGui::GetCursorPosX() + 12) {
        ImGui::SetCursorPosX(place);
        ImGui::TextDisabled("%s", workspace.renderer.c_str());
    }
}

}  // namespace studio
