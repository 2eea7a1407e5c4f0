// SPDX-License-Identifier: MIT
#include "studio/slider.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>
#include <imgui_internal.h>

namespace studio {
namespace {

constexpr float label_share = 0.36f;

/// Sets the default on a double-click. The press itself already moves the slider: letting go of it
/// keeps the default from being overwritten while the button is still down.
bool reset_on_double_click() {
    if (!ImGui::IsItemHovered() || !ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        return false;
    if (ImGui::GetIO().KeyCtrl) return false;
    ImGui::ClearActiveID();
    return true;
}

double snapped(double value, const SliderRange& range) {
    if (range.step > 0) {
        value = range.minimum + range.step * std::round((value - range.minimum) / range.step);
    }
    return std::clamp(value, range.minimum, range.maximum);
}

double to_screen(double linear) {
    linear = std::clamp(linear, 0.0, 1.0);
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double to_linear(double shown) {
    return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

std::string hidden(const char* label) { return std::string("##") + label; }

}  // namespace

void label_on_the_left(const char* label) {
    const float whole = ImGui::GetContentRegionAvail().x;
    const float start = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    const float width = whole * label_share - ImGui::GetStyle().ItemSpacing.x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::PushClipRect(corner, ImVec2(corner.x + width, corner.y + ImGui::GetFrameHeight()), true);
    ImGui::TextUnformatted(label, ImGui::FindRenderedTextEnd(label));
    ImGui::PopClipRect();
    const bool cut = ImGui::CalcTextSize(label, nullptr, true).x > width;
    if (cut && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", label);
    ImGui::SameLine(start + whole * label_share);
    ImGui::SetNextItemWidth(-1);
}

void tooltip_of_last(const std::string& text) {
    if (text.empty() || !ImGui::IsItemHovered() || ImGui::IsItemActive()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool slider(const char* label, double& value, const SliderRange& range,
            const std::string& tooltip) {
    label_on_the_left(label);
    ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
    if (range.logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
    double moved = value;
    bool changed = ImGui::SliderScalar(hidden(label).c_str(), ImGuiDataType_Double, &moved,
                                       &range.minimum, &range.maximum, range.format, flags);
    if (changed) moved = snapped(moved, range);
    if (reset_on_double_click()) {
        moved = range.initial;
        changed = true;
    }
    tooltip_of_last(tooltip);
    if (!changed || moved == value) return false;
    value = moved;
    return true;
}

bool slider(const char* label, int& value, const SliderRange& range, const std::string& tooltip) {
    SliderRange whole = range;
    whole.format = "%.0f";
    double number = value;
    if (!slider(label, number, whole, tooltip)) return false;
    const int rounded = static_cast<int>(std::lround(number));
    const bool changed = rounded != value;
    value = rounded;
    return changed;
}

bool vector_field(const char* label, glm::dvec3& value, double speed, const std::string& tooltip) {
    label_on_the_left(label);
    glm::dvec3 moved = value;
    bool changed = ImGui::DragScalarN(hidden(label).c_str(), ImGuiDataType_Double, &moved.x, 3,
                                      static_cast<float>(speed), nullptr, nullptr, "%.4g");
    tooltip_of_last(tooltip);
    for (int i = 0; i < 3; ++i) changed = changed && std::isfinite(moved[i]);
    if (changed) value = moved;
    return changed;
}

bool number_field(const char* label, double& value, double speed, double minimum, double maximum,
                  const std::string& tooltip) {
    label_on_the_left(label);
    double moved = value;
    const bool changed = ImGui::DragScalar(hidden(label).c_str(), ImGuiDataType_Double, &moved,
                                           static_cast<float>(speed), &minimum, &maximum, "%.4g",
                                           ImGuiSliderFlags_AlwaysClamp);
    tooltip_of_last(tooltip);
    if (!changed || !std::isfinite(moved)) return false;
    value = moved;
    return true;
}

bool colour_field(const char* label, glm::dvec3& linear, const glm::dvec3& initial) {
    if (label[0] != '#') label_on_the_left(label);
    float shown[3];
    for (int i = 0; i < 3; ++i) shown[i] = static_cast<float>(to_screen(linear[i]));
    const std::string id = label[0] == '#' ? std::string(label) : hidden(label);
    bool changed = ImGui::ColorEdit3(
        id.c_str(), shown, ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_PickerHueWheel);
    if (changed) {
        for (int i = 0; i < 3; ++i) linear[i] = to_linear(shown[i]);
    }
    if (ImGui::BeginPopupContextItem((id + "reset").c_str())) {
        if (ImGui::MenuItem("Default colour")) {
            linear = initial;
            changed = true;
        }
        ImGui::EndPopup();
    }
    return changed;
}

bool check(const char* label, bool& value, const std::string& tooltip) {
    const bool changed = ImGui::Checkbox(label, &value);
    tooltip_of_last(tooltip);
    return changed;
}

}  // namespace studio
