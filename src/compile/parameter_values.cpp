// SPDX-License-Identifier: MIT
#include "compile/parameter_values.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/near_name.h"

namespace compile {
namespace {

using field::Parameter;
using field::ParameterType;

/// What a value of the parameter must be, for people.
std::string wanted(const Parameter& parameter) {
    switch (parameter.type) {
        case ParameterType::real:
        case ParameterType::integer:
        case ParameterType::logarithmic:
        case ParameterType::angle:
        case ParameterType::colour:
            break;
        case ParameterType::choice:
            return fmt::format("one of \"{}\"", fmt::join(parameter.choices, "\", \""));
        case ParameterType::toggle:
            return "true or false";
    }
    if (parameter.size() == 1) return "a number";
    return fmt::format("a list of {} numbers", parameter.size());
}

/// What a value is, for people.
struct Describe {
    std::string operator()(double value) const { return fmt::format("{}", value); }
    std::string operator()(const std::vector<double>& list) const {
        return fmt::format("a list of {}", list.size());
    }
    std::string operator()(const std::string& text) const { return fmt::format("\"{}\"", text); }
    std::string operator()(bool on) const { return on ? "true" : "false"; }
};

/// The components of a value, as long as it is of the right kind.
struct Convert {
    using Components = std::optional<std::vector<double>>;
    const Parameter& parameter;

    bool is(ParameterType type) const { return parameter.type == type; }

    Components operator()(double value) const {
        if (parameter.size() != 1) return std::nullopt;
        if (is(ParameterType::choice) || is(ParameterType::toggle)) {
            const bool index = value == std::round(value) && value >= parameter.minimum &&
                               value <= parameter.maximum;
            if (!index) return std::nullopt;
        }
        return std::vector{value};
    }
    Components operator()(const std::vector<double>& list) const {
        if (list.size() == 1 || list.size() != parameter.size()) return std::nullopt;
        return list;
    }
    Components operator()(const std::string& label) const {
        if (!is(ParameterType::choice)) return std::nullopt;
        const auto place = std::ranges::find(parameter.choices, label);
        if (place == parameter.choices.end()) return std::nullopt;
        return std::vector{static_cast<double>(place - parameter.choices.begin())};
    }
    Components operator()(bool on) const {
        if (!is(ParameterType::toggle)) return std::nullopt;
        return std::vector{on ? 1.0 : 0.0};
    }
};

std::string unknown_name(const field::Field& field, const std::string& name) {
    std::vector<std::string> known;
    for (const Parameter& parameter : field.parameters) known.push_back(parameter.name);
    std::string message = fmt::format("unknown parameter '{}' is ignored", name);
    const std::string meant = scene::near_name(name, known);
    if (!meant.empty()) message += fmt::format("; did you mean '{}'?", meant);
    return message;
}

}  // namespace

base::Result<std::vector<double>> components(const Parameter& parameter,
                                             const scene::ParameterValue& value) {
    auto components = std::visit(Convert{parameter}, value);
    if (!components) {
        return base::error(
            fmt::format("{}, not {}", wanted(parameter), std::visit(Describe{}, value)));
    }
    if (parameter.type == ParameterType::integer) {
        for (double& component : *components) component = std::round(component);
    }
    return *std::move(components);
}

std::vector<double> components_in(const scene::Document& document, const Parameter& parameter) {
    const auto moved = document.parameters.find(parameter.name);
    if (moved == document.parameters.end()) return parameter.initial;
    auto fitting = components(parameter, moved->second);
    return fitting ? *std::move(fitting) : parameter.initial;
}

void set_components(scene::Document& document, const Parameter& parameter,
                    const std::vector<double>& components) {
    if (components == parameter.initial) {
        document.parameters.erase(parameter.name);
        return;
    }
    scene::ParameterValue& value = document.parameters[parameter.name];
    if (parameter.type == ParameterType::toggle) {
        value = components[0] != 0;
    } else if (parameter.type == ParameterType::choice) {
        value = parameter.choices[static_cast<std::size_t>(components[0])];
    } else if (components.size() == 1) {
        value = components[0];
    } else {
        value = components;
    }
}

std::vector<double> parameter_values(const field::Field& field, const scene::Document& document) {
    std::vector<double> values(field.graph.parameter_count(), 0.0);
    values[index(graph::parameter_t)] = document.time;
    for (const Parameter& parameter : field.parameters) {
        const std::vector<double> components = components_in(document, parameter);
        for (std::size_t i = 0; i < parameter.size(); ++i) {
            values[index(parameter.ids[i])] = components[i];
        }
    }
    return values;
}

base::Diagnostics check_parameters(const field::Field& field, const scene::ParameterValues& values,
                                   const scene::ParameterPlaces& places) {
    base::Diagnostics problems;
    for (const auto& [name, value] : values) {
        const auto place = places.find(name);
        const auto at = [&](auto member) -> std::optional<base::SourceSpan> {
            if (place == places.end()) return std::nullopt;
            return place->second.*member;
        };
        const auto parameter = std::ranges::find(field.parameters, name, &Parameter::name);
        if (parameter == field.parameters.end()) {
            problems.push_back({base::Severity::warning, unknown_name(field, name),
                                at(&scene::ParameterPlace::name)});
        } else if (auto fitting = components(*parameter, value); !fitting) {
            problems.push_back(
                {base::Severity::error,
                 fmt::format("'parameters.{}' must be {}", name, fitting.problems()[0].message),
                 at(&scene::ParameterPlace::value)});
        }
    }
    std::ranges::stable_sort(problems, {}, [](const base::Diagnostic& problem) {
        return problem.span ? problem.span->begin : 0;
    });
    return problems;
}

}  // namespace compile
