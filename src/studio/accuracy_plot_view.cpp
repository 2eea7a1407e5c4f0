// SPDX-License-Identifier: MIT
// The plot of wrong pixels against time, which can be clicked.
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "studio/accuracy_plot.h"
#include "studio/label_places.h"
#include "studio/panels.h"
#include "studio/slider.h"

namespace studio {
namespace {

constexpr ImU32 paper = IM_COL32(0x14, 0x16, 0x1B, 255),
                label_paper = IM_COL32(0x14, 0x16, 0x1B, 190),
                grid = IM_COL32(0x2B, 0x30, 0x3A, 255),
                curve_colour = IM_COL32(0x3F, 0x97, 0xA5, 255),
                dot = IM_COL32(0xB6, 0xBE, 0xCA, 255), old_dot = IM_COL32(0x5A, 0x62, 0x70, 255),
                accent = IM_COL32(0xF0, 0xB4, 0x4A, 255);

/// The plot on the screen.
struct Sheet {
    ImVec2 corner, size;  ///< of the area between the axes
    float radius = 4;     ///< of a point
    AccuracyPlot plot;

    ImVec2 at(double milliseconds, double wrong) const {
        return {corner.x + size.x * static_cast<float>(plot.milliseconds.place(milliseconds)),
                corner.y + size.y * static_cast<float>(1 - plot.wrong.place(wrong))};
    }
    ImVec2 at(const PlotPoint& point) const { return at(point.milliseconds, point.wrong); }
};

void draw_text(ImVec2 place, ImU32 colour, const std::string& text) {
    ImGui::GetWindowDrawList()->AddText(place, colour, text.c_str());
}

void draw_axes(const Sheet& sheet) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end(sheet.corner.x + sheet.size.x, sheet.corner.y + sheet.size.y);
    const float margin = 2 * sheet.radius;
    list.AddRectFilled(ImVec2(sheet.corner.x - margin, sheet.corner.y - margin),
                       ImVec2(end.x + margin, end.y + margin), paper, sheet.radius);
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    std::vector<double> wrong = sheet.plot.wrong.ticks();
    wrong.push_back(0);
    for (const double tick : wrong) {
        const std::string label = fmt::format("{:g}", tick);
        const ImVec2 extent = ImGui::CalcTextSize(label.c_str());
        const float y = sheet.at(sheet.plot.milliseconds.low, tick).y;
        list.AddLine(ImVec2(sheet.corner.x - margin, y), ImVec2(end.x + margin, y), grid);
        draw_text(ImVec2(sheet.corner.x - 2 * margin - extent.x, y - extent.y / 2), text, label);
    }
    float free = sheet.corner.x - 100;
    for (const double tick : sheet.plot.milliseconds.ticks()) {
        const std::string label = fmt::format("{:g}", tick);
        const ImVec2 extent = ImGui::CalcTextSize(label.c_str());
        const float x = sheet.at(tick, 0).x;
        list.AddLine(ImVec2(x, sheet.corner.y - margin), ImVec2(x, end.y + margin), grid);
        if (x - extent.x / 2 < free) continue;
        draw_text(ImVec2(x - extent.x / 2, end.y + margin + 2), text, label);
        free = x + extent.x / 2 + margin;
    }
}

void draw_curves(const Sheet& sheet) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const PlotCurve& curve : sheet.plot.curves) {
        for (std::size_t i = 1; i < curve.size(); ++i) {
            list.AddLine(sheet.at(sheet.plot.points[curve[i - 1]]),
                         sheet.at(sheet.plot.points[curve[i]]), curve_colour, 1.5f);
        }
    }
}

void draw_points(const Sheet& sheet) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (auto point = sheet.plot.points.rbegin(); point != sheet.plot.points.rend(); ++point) {
        const ImVec2 place = sheet.at(*point);
        const ImU32 colour = point->present ? accent : point->alike ? dot : old_dot;
        list.AddCircleFilled(place, sheet.radius * (point->alike ? 1 : 0.7f), colour);
        if (point->present) list.AddCircle(place, 2 * sheet.radius, accent, 0, 1.5f);
    }
}

void draw_labels(const Sheet& sheet) {
    std::vector<LabelledPoint> points;
    for (const PlotPoint& point : sheet.plot.points) {
        const ImVec2 place = sheet.at(point);
        const ImVec2 extent = ImGui::CalcTextSize(point.label.c_str());
        points.push_back({place.x, place.y, extent.x, extent.y});
    }
    const float margin = 2 * sheet.radius;
    const PlotBox frame{sheet.corner.x - margin, sheet.corner.y - margin,
                        sheet.corner.x + sheet.size.x + margin,
                        sheet.corner.y + sheet.size.y + margin};
    const auto places = label_places(points, frame, 2 * sheet.radius);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!places[i]) continue;
        const PlotPoint& point = sheet.plot.points[i];
        const ImVec2 corner(static_cast<float>(places[i]->x), static_cast<float>(places[i]->y));
        const ImVec2 end(corner.x + static_cast<float>(points[i].width),
                         corner.y + static_cast<float>(points[i].height));
        ImGui::GetWindowDrawList()->AddRectFilled(corner, end, label_paper, sheet.radius);
        draw_text(corner, point.present ? accent : ImGui::GetColorU32(ImGuiCol_Text), point.label);
    }
}

/// The point under the mouse, the nearest of several.
const PlotPoint* hovered_point(const Sheet& sheet) {
    if (!ImGui::IsItemHovered()) return nullptr;
    const ImVec2 mouse = ImGui::GetMousePos();
    const PlotPoint* nearest = nullptr;
    float least = 2.5f * sheet.radius;
    for (const PlotPoint& point : sheet.plot.points) {
        const ImVec2 place = sheet.at(point);
        const float distance = std::hypot(place.x - mouse.x, place.y - mouse.y);
        if (distance > least || (nearest && distance == least)) continue;
        nearest = &point;
        least = distance;
    }
    return nearest;
}

std::string words_about(const MeasuredSetting& setting, bool present) {
    const oracle::Metrics& metrics = setting.judged->metrics;
    const auto [least, most] = std::ranges::minmax(setting.seconds);
    return fmt::format(
        "{}{}\nsteps at most {}, epsilon {:.4g}\n{} wrong: {} missed, {} phantom, {} moved\n"
        "{} unresolved\n{:.2f} ms a frame (median of {}: {:.2f} to {:.2f}){}",
        describe(setting.tracing), present ? " (the present setting)" : "", setting.tracing.steps,
        setting.tracing.epsilon, metrics.wrong(), metrics.missed, metrics.phantom, metrics.moved,
        metrics.gave_up, 1000 * *setting.frame_seconds(), setting.seconds.size(), 1000 * least,
        1000 * most, present ? "" : "\nClick to use it.");
}

void show_sheet(Workspace& workspace, const Sheet& sheet) {
    draw_axes(sheet);
    draw_curves(sheet);
    draw_points(sheet);
    draw_labels(sheet);
    const PlotPoint* point = hovered_point(sheet);
    if (!point) return;
    const MeasuredSetting& setting = workspace.accuracy.measured[point->index];
    ImGui::GetWindowDrawList()->AddCircle(sheet.at(*point), 2 * sheet.radius,
                                          ImGui::GetColorU32(ImGuiCol_Text), 0, 1.5f);
    tooltip_of_last(words_about(setting, point->present));
    if (ImGui::IsItemClicked()) apply(setting.tracing, workspace.document.settings);
}

}  // namespace

void show_accuracy_plot(Workspace& workspace) {
    const Accuracy& accuracy = workspace.accuracy;
    Sheet sheet{.corner = {},
                .size = {},
                .radius = 4 * workspace.scale,
                .plot = accuracy_plot(accuracy, tracing_of(workspace.document.settings))};
    if (sheet.plot.points.empty()) return;
    ImGui::TextDisabled("wrong pixels, against ms a frame of %d x %d", accuracy.reference->width,
                        accuracy.reference->height);
    const float line = ImGui::GetTextLineHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 whole(std::max(room.x, 8 * line), std::max(room.y, 10 * line));
    const float left = ImGui::CalcTextSize("100000").x + 4 * sheet.radius;
    const float margin = 2 * sheet.radius;
    sheet.corner = ImVec2(corner.x + left, corner.y + margin + 2);
    sheet.size = ImVec2(whole.x - left - 2 * margin, whole.y - 2 * margin - line - 6);
    ImGui::InvisibleButton("plot", whole);
    show_sheet(workspace, sheet);
}

}  // namespace studio
