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
    linear = std::max(linear, 0.0);
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double to_linear(double shown) {
    return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

std::string hidden(const char* label) { return std::string("##") + label; }

/// The slider itself, without its label.
bool slide(const char* id, double& value, const SliderRange& range, const std::string& tooltip) {
    ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
    if (range.logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
    double moved = value;
    bool changed = ImGui::SliderScalar(id, ImGuiDataType_Double, &moved, &range.minimum,
                                       &range.maximum, range.format, flags);
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

/// A menu under the right button with nothing but the default.
bool reset_from_menu(const std::string& id) {
    if (!ImGui::BeginPopupContextItem((id + "reset").c_str())) return false;
    const bool chosen = ImGui::MenuItem("Default");
    ImGui::EndPopup();
    return chosen;
}

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
    return slide(hidden(label).c_str(), value, range, tooltip);
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

bool slider_row(const char* label, std::span<double> values, std::span<const SliderRange> ranges,
                const std::string& tooltip) {
    label_on_the_left(label);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const auto count = static_cast<float>(values.size());
    const float width = (ImGui::GetContentRegionAvail().x - gap * (count - 1)) / count;
    bool changed = false;
    ImGui::PushID(label);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) ImGui::SameLine(0, gap);
        ImGui::SetNextItemWidth(width);
        ImGui::PushID(static_cast<int>(i));
        changed |= slide("##component", values[i], ranges[i], tooltip);
        ImGui::PopID();
    }
    ImGui::PopID();
    return changed;
}

bool choice(const char* label, std::size_t& chosen, std::span<const std::string> labels,
            std::size_t initial, const std::string& tooltip) {
    label_on_the_left(label);
    const std::string id = hidden(label);
    const std::size_t before = chosen;
    const bool open = ImGui::BeginCombo(id.c_str(), labels[chosen].c_str());
    if (open) {
        for (std::size_t i = 0; i < labels.size(); ++i) {
            ImGui::PushID(static_cast<int>(i));
            if (ImGui::Selectable(labels[i].c_str(), i == chosen)) chosen = i;
            if (i == chosen) ImGui::SetItemDefaultFocus();
            ImGui::PopID();
        }
        ImGui::EndCombo();
    } else {
        tooltip_of_last(tooltip);
    }
    if (reset_from_menu(id)) chosen = initial;
    return chosen != before;
}

bool toggle(const char* label, bool& on, bool initial, const std::string& tooltip) {
    label_on_the_left(label);
    const std::string id = hidden(label);
    const bool before = on;
    ImGui::Checkbox(id.c_str(), &on);
    tooltip_of_last(tooltip);
    if (reset_from_menu(id)) on = initial;
    return on != before;
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

bool colour_field(const char* label, glm::dvec3& linear, const glm::dvec3& initial,
                  bool brighter_than_white, const std::string& tooltip) {
    if (label[0] != '#') label_on_the_left(label);
    float shown[3];
    for (int i = 0; i < 3; ++i) shown[i] = static_cast<float>(to_screen(linear[i]));
    const std::string id = label[0] == '#' ? std::string(label) : hidden(label);
    const ImGuiColorEditFlags flags = brighter_than_white
                                          ? ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_Float
                                          : ImGuiColorEditFlags_DisplayHex;
    bool changed = ImGui::ColorEdit3(id.c_str(), shown, flags | ImGuiColorEditFlags_PickerHueWheel);
    if (changed) {
        for (int i = 0; i < 3; ++i) linear[i] = to_linear(shown[i]);
    }
    tooltip_of_last(tooltip);
    if (reset_from_menu(id)) {
        linear = initial;
        changed = true;
    }
    return changed;
}

bool check(const char* label, bool& value, const std::string& tooltip) {
    const bool changed = ImGui::Checkbox(label, &value);
    tooltip_of_last(tooltip);
    return changed;
}

}  // namespace studio
