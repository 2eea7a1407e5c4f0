// SPDX-License-Identifier: MIT
#include "studio/parameter_control.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "studio/slider.h"

namespace studio {
namespace {

using field::Parameter;
using field::ParameterType;

constexpr double degrees = 180 / std::numbers::pi;

/// What is shown for 1.
double unit_of(const Parameter& parameter) {
    return parameter.type == ParameterType::angle ? degrees : 1;
}

const char* format_of(const Parameter& parameter) {
    const auto whole = [](double value) { return value == std::round(value); };
    if (parameter.type == ParameterType::angle) return parameter.size() > 2 ? "%.0f°" : "%.1f°";
    if (parameter.type == ParameterType::integer) return "%.0f";
    if (parameter.step && whole(*parameter.step) && whole(parameter.minimum)) return "%.0f";
    return parameter.size() > 2 ? "%.3g" : "%.4g";
}

SliderRange range_of(const Parameter& parameter, std::size_t component) {
    const double unit = unit_of(parameter);
    const double any_step = parameter.type == ParameterType::integer ? 1 : 0;
    return {.minimum = parameter.minimum * unit,
            .maximum = parameter.maximum * unit,
            .initial = parameter.initial[component] * unit,
            .logarithmic = parameter.type == ParameterType::logarithmic,
            .step = parameter.step.value_or(any_step) * unit,
            .format = format_of(parameter)};
}

std::string default_of(const Parameter& parameter) {
    if (parameter.type == ParameterType::choice) {
        return parameter.choices[static_cast<std::size_t>(parameter.initial[0])];
    }
    if (parameter.type == ParameterType::toggle) return parameter.initial[0] != 0 ? "on" : "off";
    const double unit = unit_of(parameter);
    std::string list;
    for (const double value : parameter.initial) {
        list += fmt::format("{}{:.6g}", list.empty() ? "" : ", ", value * unit);
    }
    return parameter.size() > 1 ? fmt::format("({})", list) : list;
}

std::string tooltip_of(const Parameter& parameter) {
    std::string text = parameter.tooltip.empty() ? "" : parameter.tooltip + "\n\n";
    text += parameter.name;
    switch (parameter.type) {
        case ParameterType::choice:
        case ParameterType::toggle:
        case ParameterType::colour:
            return fmt::format("{}, by default {}\nRight-click for the default.", text,
                               default_of(parameter));
        case ParameterType::real:
        case ParameterType::integer:
        case ParameterType::logarithmic:
        case ParameterType::angle:
            break;
    }
    const double unit = unit_of(parameter);
    return fmt::format(
        "{} in [{:.6g}, {:.6g}]{}, by default {}\nDouble-click for the default, Ctrl+click to "
        "type a number.",
        text, parameter.minimum * unit, parameter.maximum * unit,
        parameter.type == ParameterType::angle ? " degrees" : "", default_of(parameter));
}

bool colour(const char* label, const Parameter& parameter, std::vector<double>& components,
            const std::string& tooltip) {
    glm::dvec3 linear(components[0], components[1], components[2]);
    const glm::dvec3 initial(parameter.initial[0], parameter.initial[1], parameter.initial[2]);
    if (!colour_field(label, linear, initial, parameter.maximum > 1, tooltip)) return false;
    for (int i = 0; i < 3; ++i) {
        components[static_cast<std::size_t>(i)] =
            std::clamp(linear[i], parameter.minimum, parameter.maximum);
    }
    return true;
}

bool sliders(const char* label, const Parameter& parameter, std::vector<double>& components,
             const std::string& tooltip) {
    const double unit = unit_of(parameter);
    std::vector<double> shown;
    std::vector<SliderRange> ranges;
    for (std::size_t i = 0; i < components.size(); ++i) {
        shown.push_back(components[i] * unit);
        ranges.push_back(range_of(parameter, i));
    }
    const std::vector<double> before = shown;
    const bool changed = components.size() == 1 ? slider(label, shown[0], ranges[0], tooltip)
                                                : slider_row(label, shown, ranges, tooltip);
    if (!changed) return false;
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (shown[i] == before[i]) continue;
        // Back from degrees the default is only almost itself.
        const bool initial = shown[i] == ranges[i].initial;
        components[i] = initial ? parameter.initial[i] : shown[i] / unit;
    }
    return true;
}

}  // namespace

bool parameter_control(const Parameter& parameter, std::vector<double>& components) {
    const std::string label = parameter.label + "##" + parameter.name;
    const std::string tooltip = tooltip_of(parameter);
    switch (parameter.type) {
        case ParameterType::real:
        case ParameterType::integer:
        case ParameterType::logarithmic:
        case ParameterType::angle:
            break;
        case ParameterType::colour:
            return colour(label.c_str(), parameter, components, tooltip);
        case ParameterType::choice: {
            auto chosen = static_cast<std::size_t>(components[0]);
            const auto initial = static_cast<std::size_t>(parameter.initial[0]);
            const bool changed = choice(label.c_str(), chosen, parameter.choices, initial, tooltip);
            components[0] = static_cast<double>(chosen);
            return changed;
        }
        case ParameterType::toggle: {
            bool on = components[0] != 0;
            const bool changed = toggle(label.c_str(), on, parameter.initial[0] != 0, tooltip);
            components[0] = on ? 1 : 0;
            return changed;
        }
    }
    return sliders(label.c_str(), parameter, components, tooltip);
}

}  // namespace studio
