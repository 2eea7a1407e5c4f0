// SPDX-License-Identifier: MIT
// Controls for numbers and colours of the document, all in one manner: the label on the left,
// double-click for the default, Ctrl+click to type.
#pragma once

#include <span>
#include <string>

#include <glm/vec3.hpp>

namespace studio {

struct SliderRange {
    double minimum = 0, maximum = 1;
    double initial = 0;  ///< what a double-click sets
    bool logarithmic = false;
    double step = 0;  ///< values are whole multiples of it above the minimum; 0: any
    const char* format = "%.4g";
};

/// Each answers whether the value has changed.
bool slider(const char* label, double& value, const SliderRange& range,
            const std::string& tooltip = {});
bool slider(const char* label, int& value, const SliderRange& range,
            const std::string& tooltip = {});
/// Three numbers, dragged.
bool vector_field(const char* label, glm::dvec3& value, double speed,
                  const std::string& tooltip = {});
/// One number, dragged.
bool number_field(const char* label, double& value, double speed, double minimum, double maximum,
                  const std::string& tooltip = {});
/// Sliders side by side, one a component.
bool slider_row(const char* label, std::span<double> values, std::span<const SliderRange> ranges,
                const std::string& tooltip = {});
/// One of some labels; the right button offers the initial one.
bool choice(const char* label, std::size_t& chosen, std::span<const std::string> labels,
            std::size_t initial, const std::string& tooltip = {});
/// On or off; the right button offers the initial state.
bool toggle(const char* label, bool& on, bool initial, const std::string& tooltip = {});
/// A linear colour, shown and picked as it looks on the screen; the right button offers the initial
/// one. Components above 1 can be typed if it may be brighter than white.
bool colour_field(const char* label, glm::dvec3& linear, const glm::dvec3& initial,
                  bool brighter_than_white = false, const std::string& tooltip = {});
bool check(const char* label, bool& value, const std::string& tooltip = {});

/// The label of the next control, on the left of it; the control fills the rest of the line.
void label_on_the_left(const char* label);
/// Shows a text beside the mouse while the last control is hovered.
void tooltip_of_last(const std::string& text);

}  // namespace studio
