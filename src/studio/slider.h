// SPDX-License-Identifier: MIT
// Controls for numbers and colours of the document, all in one manner: the label on the left,
// double-click for the default, Ctrl+click to type.
#pragma once

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
/// A linear colour, shown and picked as it looks on the screen.
bool colour_field(const char* label, glm::dvec3& linear, const glm::dvec3& initial);
bool check(const char* label, bool& value, const std::string& tooltip = {});

/// The label of the next control, on the left of it; the control fills the rest of the line.
void label_on_the_left(const char* label);
/// Shows a text beside the mouse while the last control is hovered.
void tooltip_of_last(const std::string& text);

}  // namespace studio
