// SPDX-License-Identifier: MIT
#include "cli/set_parameter.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/number.h"
#include "compile/parameter_values.h"
#include "scene/near_name.h"

namespace cli {
namespace {

using field::Parameter;
using field::ParameterType;
using Components = std::vector<double>;

constexpr std::string_view letters = "xyzw";

base::Diagnostic no_number(std::string_view text) {
    return base::error(fmt::format("'{}' is not a finite number", text));
}

base::Result<Components> read_choice(const Parameter& parameter, std::string_view text) {
    auto found = compile::components(parameter, std::string(text));
    if (found) return found;
    if (const auto index = finite_number(text)) {
        if (auto by_index = compile::components(parameter, *index)) return by_index;
    }
    const std::string meant = scene::near_name(text, parameter.choices);
    return base::error(fmt::format(
        "'{}' is one of '{}', not '{}'{}", parameter.name, fmt::join(parameter.choices, "', '"),
        text, meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant)));
}

base::Result<Components> read_toggle(const Parameter& parameter, std::string_view text) {
    if (text == "on" || text == "true" || text == "1") return Components{1};
    if (text == "off" || text == "false" || text == "0") return Components{0};
    return base::error(fmt::format("'{}' is on or off, not '{}'", parameter.name, text));
}

base::Result<Components> read_numbers(const Parameter& parameter, std::string_view text) {
    if (parameter.size() == 1) {
        const auto value = finite_number(text);
        if (!value) return no_number(text);
        return Components{*value};
    }
    Components components;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        const std::string_view part = text.substr(begin, comma - begin);
        const auto value = finite_number(part);
        if (!value) return no_number(part);
        components.push_back(*value);
        begin = comma + 1;
    }
    if (components.size() == parameter.size()) return components;
    return base::error(fmt::format(
        "'{}' takes {} numbers, such as {}={}, and {}.x sets one of them", parameter.name,
        parameter.size(), parameter.name, fmt::join(parameter.initial, ","), parameter.name));
}

base::Result<Components> read_components(const Parameter& parameter, std::string_view text) {
    switch (parameter.type) {
        case ParameterType::real:
        case ParameterType::integer:
        case ParameterType::logarithmic:
        case ParameterType::angle:
        case ParameterType::colour:
            break;
        case ParameterType::choice:
            return read_choice(parameter, text);
        case ParameterType::toggle:
            return read_toggle(parameter, text);
    }
    return read_numbers(parameter, text);
}

/// All components, of which one is set.
base::Result<Components> read_component(const Parameter& parameter, std::string_view letter,
                                        std::string_view text, const scene::Document& document) {
    const std::size_t place = letter.size() == 1 ? letters.find(letter) : std::string::npos;
    if (parameter.size() == 1) {
        return base::error(fmt::format("'{}' is a single value and has no components; write {}={}",
                                       parameter.name, parameter.name, text));
    }
    if (place >= parameter.size()) {
        return base::error(fmt::format("'{}' has the components '{}', not '{}'", parameter.name,
                                       fmt::join(letters.substr(0, parameter.size()), "', '"),
                                       letter));
    }
    const auto value = finite_number(text);
    if (!value) return no_number(text);
    Components components = compile::components_in(document, parameter);
    components[place] = *value;
    return components;
}

base::Diagnostic unknown_name(const field::Field& field, std::string_view name) {
    std::string names;
    for (const Parameter& p : field.parameters) names += (names.empty() ? "" : ", ") + p.name;
    return base::error(fmt::format("the formula has no parameter '{}'; it has {}", name,
                                   names.empty() ? "none besides t" : names));
}

}  // namespace

base::Status set_parameter(const field::Field& field, std::string_view name, std::string_view value,
                           scene::Document& document) {
    const std::size_t dot = std::min(name.find('.'), name.size());
    const std::string_view whole = name.substr(0, dot);
    const auto parameter = std::ranges::find(field.parameters, whole, &Parameter::name);
    if (parameter != field.parameters.end()) {
        auto components = dot == name.size()
                              ? read_components(*parameter, value)
                              : read_component(*parameter, name.substr(dot + 1), value, document);
        if (!components) return components.problems();
        compile::set_components(document, *parameter, *components);
        return base::Done{};
    }
    if (name != "t") return unknown_name(field, name);
    const auto seconds = finite_number(value);
    if (!seconds) return no_number(value);
    document.time = *seconds;
    return base::Done{};
}

}  // namespace cli
