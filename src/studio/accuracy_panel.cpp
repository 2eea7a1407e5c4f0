// SPDX-License-Identifier: MIT
// How wrong the picture is, against the reference.
#include <array>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "studio/accuracy_report.h"
#include "studio/overlay_colours.h"
#include "studio/panels.h"
#include "studio/slider.h"

namespace studio {
namespace {

using Phase = Accuracy::Phase;
using Wish = Accuracy::Wish;

const ImVec4 good(0.50f, 0.80f, 0.47f, 1), doubtful(0.91f, 0.75f, 0.35f, 1),
    bad(0.96f, 0.48f, 0.43f, 1);

std::string size_text(const Workspace& workspace, int divisor) {
    const ReferenceKey key =
        reference_key(workspace.document, {}, workspace.area.width, workspace.area.height, divisor);
    const std::string part = divisor == 1 ? "full" : fmt::format("1/{}", divisor);
    return fmt::format("{}: {} x {}", part, key.width, key.height);
}

void show_size(Workspace& workspace) {
    Accuracy& accuracy = workspace.accuracy;
    label_on_the_left("Size");
    if (ImGui::BeginCombo("##size", size_text(workspace, accuracy.divisor).c_str())) {
        for (const int divisor : check_divisors) {
            const std::string text = size_text(workspace, divisor);
            if (ImGui::Selectable(text.c_str(), divisor == accuracy.divisor)) {
                accuracy.divisor = divisor;
            }
        }
        ImGui::EndCombo();
    }
    tooltip_of_last(
        "The picture that is checked: the same view with fewer and larger pixels. Epsilon counts "
        "in them.");
}

void show_commands(Workspace& workspace) {
    Accuracy& accuracy = workspace.accuracy;
    const bool playing = workspace.playback.playing;
    ImGui::BeginDisabled(playing || accuracy.phase == Phase::tracing);
    if (ImGui::Button("Check this view (F5)")) accuracy.wish = Wish::check;
    ImGui::EndDisabled();
    tooltip_of_last(playing ? "Stop the time first."
                            : "Finds the first surface along every ray in double precision, with a "
                              "proof where there is one, and compares the picture with that.");
    ImGui::SameLine();
    check("Keep checking", accuracy.keep_checking,
          "Checks again by itself when the view has come to rest.");
    show_size(workspace);
}

void show_progress(Workspace& workspace) {
    Accuracy& accuracy = workspace.accuracy;
    if (accuracy.phase == Phase::idle || accuracy.phase == Phase::judging) {
        // The same height as with a bar, so that nothing below jumps.
        ImGui::AlignTextToFramePadding();
        if (!accuracy.problem.empty()) {
            ImGui::PushStyleColor(ImGuiCol_Text, bad);
            ImGui::TextWrapped("%s", accuracy.problem.c_str());
            ImGui::PopStyleColor();
        } else if (accuracy.reference) {
            const ReportLine certain = certainty(*accuracy.reference);
            ImGui::TextColored(accuracy.reference->heuristic ? doubtful : good, "%s reference",
                               certain.word.c_str());
            tooltip_of_last(certain.help);
            ImGui::SameLine();
            ImGui::TextDisabled("in %.1f s", accuracy.reference_seconds);
        } else {
            ImGui::TextDisabled("not checked yet");
        }
        return;
    }
    const float button = 70 * workspace.scale;
    const char* what = accuracy.phase == Phase::tracing ? "tracing the reference" : "measuring";
    const std::string text = fmt::format("{}: {:.0f} %", what, 100 * accuracy.progress);
    ImGui::ProgressBar(static_cast<float>(accuracy.progress),
                       ImVec2(-button - ImGui::GetStyle().ItemSpacing.x, 0), text.c_str());
    ImGui::SameLine();
    if (ImGui::Button("Cancel", ImVec2(button, 0))) accuracy.wish = Wish::cancel;
}

void show_mark(const ReportLine& line) {
    const float side = ImGui::GetTextLineHeight();
    if (line.mark) {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float margin = 0.15f * side;
        ImGui::GetWindowDrawList()->AddRectFilled(
            ImVec2(corner.x + margin, corner.y + margin),
            ImVec2(corner.x + side - margin, corner.y + side - margin),
            overlay_colour(*line.mark, 255));
    }
    ImGui::Dummy(ImVec2(side, side));
    ImGui::SameLine();
}

void show_lines(const oracle::Metrics& metrics) {
    if (!ImGui::BeginTable("numbers", 2, ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("word", ImGuiTableColumnFlags_WidthStretch, 2);
    ImGui::TableSetupColumn("number", ImGuiTableColumnFlags_WidthStretch, 1);
    for (const ReportLine& line : report_lines(metrics)) {
        ImGui::TableNextColumn();
        show_mark(line);
        ImGui::TextUnformatted(line.word.c_str());
        tooltip_of_last(line.help);
        ImGui::TableNextColumn();
        const float width = ImGui::CalcTextSize(line.number.c_str()).x;
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - width);
        ImGui::TextUnformatted(line.number.c_str());
        tooltip_of_last(line.help);
    }
    ImGui::EndTable();
}

void show_judgement(Workspace& workspace) {
    Accuracy& accuracy = workspace.accuracy;
    if (!accuracy.reference) return;
    if (!accuracy.of_this_view) {
        ImGui::TextColored(doubtful, "of an earlier view or size");
        tooltip_of_last("The view has changed since it was checked. Undo brings it back.");
        return;
    }
    const Judged* judged = accuracy.judged();
    if (judged) {
        const std::string text = verdict(judged->metrics);
        ImGui::TextColored(judged->metrics.wrong() == 0 ? good : bad, "%s", text.c_str());
    } else {
        ImGui::TextDisabled(accuracy.phase == Phase::judging ? "judging the present setting..."
                                                             : "the present setting is not judged");
    }
    // The numbers of the setting before stay, pale: nothing jumps while a slider is moved.
    if (!judged) judged = accuracy.last_judged.get();
    if (!judged) return;
    ImGui::BeginDisabled(!accuracy.judged());
    show_lines(judged->metrics);
    ImGui::EndDisabled();
    check("Show on the picture", accuracy.overlay,
          "Lays the wrong and the undecided pixels over the picture, in the colours above.");
    ImGui::SameLine();
    if (ImGui::Button("Copy")) ImGui::SetClipboardText(report_text(accuracy).c_str());
    tooltip_of_last("Puts these numbers and those of the plot into the clipboard, as text.");
}

void show_measuring(Workspace& workspace) {
    Accuracy& accuracy = workspace.accuracy;
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
    ImGui::BeginDisabled(accuracy.phase == Phase::tracing || accuracy.phase == Phase::measuring);
    if (ImGui::Button("Measure the settings")) accuracy.wish = Wish::measure;
    ImGui::EndDisabled();
    tooltip_of_last(
        "Draws this view with other Lipschitz scales and with the other tracers, in turns, and "
        "counts what is wrong with each.");
    show_accuracy_plot(workspace);
}

/// What the picture itself proves needs no reference.
void show_certificate_switch(Workspace& workspace) {
    scene::Settings& settings = workspace.document.settings;
    check("Show what is proven", settings.show_certificate,
          "Colours each pixel by what its own ray proves.");
    if (!settings.show_certificate) return;
    struct Colour {
        ImVec4 colour;
        const char* word;
    };
    // Those of shaders/output/certificate.glsl.
    static const Colour colours[] = {{{0.84f, 0.84f, 0.84f, 1}, "proven hit"},
                                     {{0.10f, 0.14f, 0.31f, 1}, "proven miss"},
                                     {{1.00f, 0.82f, 0.00f, 1}, "hit within rounding"},
                                     {{0.92f, 0.51f, 0.16f, 1}, "hit by guessed steps"},
                                     {{0.29f, 0.18f, 0.12f, 1}, "miss by guessed steps"},
                                     {{1.00f, 0.00f, 1.00f, 1}, "out of steps"}};
    for (const Colour& each : colours) {
        const float side = ImGui::GetTextLineHeight();
        ImGui::ColorButton(each.word, each.colour, ImGuiColorEditFlags_NoTooltip,
                           ImVec2(side, side));
        ImGui::SameLine();
        ImGui::TextUnformatted(each.word);
    }
}

}  // namespace

void show_accuracy_panel(Workspace& workspace) {
    show_commands(workspace);
    show_certificate_switch(workspace);
    show_progress(workspace);
    show_judgement(workspace);
    if (workspace.accuracy.of_this_view) show_measuring(workspace);
}

}  // namespace studio
