// SPDX-License-Identifier: MIT
// Lowers the declaration of a parameter.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "formula/lowering.h"

namespace formula {
namespace {

using Type = ParameterType;

/// A parameter that is being read, and whether all was well so far.
struct Reading {
    Lowering& lowering;
    const ParameterDeclaration& declaration;
    field::Parameter parameter{};
    Algebra algebra = Algebra::vector;  ///< of the initial value and so of all others
    bool good = true;

    void fail(base::SourceSpan span, std::string message) {
        lowering.error(span, std::move(message));
        good = false;
    }
};

/// The parameter with its type, for messages: "the integer 'n'".
std::string named(const ParameterDeclaration& declaration) {
    return fmt::format("the {} '{}'", spelling(declaration.type), declaration.name);
}

/// The finite value of a constant; an error otherwise. `what` begins the sentence.
std::optional<double> constant(Reading& reading, graph::NodeId number, base::SourceSpan span,
                               const std::string& what) {
    Lowering& lowering = reading.lowering;
    const std::optional<double> value = lowering.facts.constant(lowering.field.graph, number);
    if (value && std::isfinite(*value)) return value;
    reading.fail(span, fmt::format("{} {}", what,
                                   value ? "is not a finite number"
                                         : "must be a constant; it cannot depend on the point, the "
                                           "time or another parameter"));
    return std::nullopt;
}

/// The value of an expression that must be one constant number.
std::optional<double> constant(Reading& reading, ExpressionId id, const std::string& what) {
    const Value value = lower_expression(reading.lowering, id);
    const base::SourceSpan span = reading.lowering.span(id);
    if (const auto* number = std::get_if<graph::NodeId>(&value)) {
        return constant(reading, *number, span, what);
    }
    reading.good = false;
    if (!std::holds_alternative<Nothing>(value)) {
        const bool several = reading.parameter.size() > 1;
        reading.fail(span, fmt::format("{} must be one number{}", what,
                                       several ? "; it counts for every component" : ""));
    }
    return std::nullopt;
}

/// The components of a number or a vector; none, after an error, of anything else.
std::vector<graph::NodeId> components_of(Reading& reading, ExpressionId id) {
    const Value value = lower_expression(reading.lowering, id);
    if (const auto* number = std::get_if<graph::NodeId>(&value)) return {*number};
    if (const auto* vector = std::get_if<VectorValue>(&value)) {
        reading.algebra = vector->algebra;
        return vector->components;
    }
    reading.good = false;
    if (!std::holds_alternative<Nothing>(value)) {
        reading.fail(reading.lowering.span(id),
                     fmt::format("the initial value of '{}' must be a number or a vector, "
                                 "not {}",
                                 reading.declaration.name, describe(value)));
    }
    return {};
}

void read_initial(Reading& reading) {
    const ExpressionId id = reading.declaration.initial;
    const std::string what = fmt::format("the initial value of '{}'", reading.declaration.name);
    for (const graph::NodeId component : components_of(reading, id)) {
        const auto value = constant(reading, component, reading.lowering.span(id), what);
        if (!value) return;
        reading.parameter.initial.push_back(*value);
    }
}

/// The fewest half turns that reach an angle.
double half_turns(double angle) {
    const double turns = std::ceil(angle / std::numbers::pi - 1e-9);
    return std::max(angle, std::numbers::pi * std::max(1.0, turns));
}

/// Where none is given: a range around the initial value that suits the type.
void choose_range(Reading& reading) {
    field::Parameter& parameter = reading.parameter;
    const auto [least, greatest] = std::ranges::minmax(parameter.initial);
    const double most = std::max(std::abs(least), std::abs(greatest));
    switch (parameter.type) {
        case Type::real:
        case Type::integer:
            parameter.minimum = most == 0 ? -1 : least < 0 ? -2 * most : 0;
            parameter.maximum = most == 0 ? 1 : greatest > 0 ? 2 * most : 0;
            break;
        case Type::logarithmic:
            parameter.minimum = least / 10;
            parameter.maximum = greatest * 10;
            break;
        case Type::angle:
            parameter.maximum = half_turns(most);
            parameter.minimum = -parameter.maximum;
            break;
        case Type::choice:
            parameter.maximum = static_cast<double>(parameter.choices.size()) - 1;
            break;
        case Type::colour:
        case Type::toggle:
            break;
    }
}

void read_range(Reading& reading) {
    const auto [low, high] = *reading.declaration.range;
    const std::string of = fmt::format("of '{}'", reading.declaration.name);
    const auto minimum = constant(reading, low, "the minimum " + of);
    const auto maximum = constant(reading, high, "the maximum " + of);
    if (!minimum || !maximum) return;
    reading.parameter.minimum = *minimum;
    reading.parameter.maximum = *maximum;
    if (*minimum < *maximum) return;
    reading.fail(base::cover(reading.lowering.span(low), reading.lowering.span(high)),
                 fmt::format("the range {} is empty; write the smaller number first", of));
}

void read_step(Reading& reading) {
    const ExpressionId id = *reading.declaration.step;
    const std::string what = fmt::format("the step of '{}'", reading.declaration.name);
    reading.parameter.step = constant(reading, id, what);
    if (reading.parameter.step.value_or(1) > 0) return;
    reading.fail(reading.lowering.span(id), what + " must be above 0");
}

void expect_whole(Reading& reading, ExpressionId id, double value, std::string_view what,
                  double hint) {
    if (value == std::round(value)) return;
    reading.fail(reading.lowering.span(id), fmt::format("{} {} of {} is not whole; write {}", what,
                                                        value, named(reading.declaration), hint));
}

void check_integer(Reading& reading) {
    const ParameterDeclaration& declaration = reading.declaration;
    for (const double value : reading.parameter.initial) {
        expect_whole(reading, declaration.initial, value, "the initial value", std::round(value));
    }
    if (declaration.range) {
        const auto [low, high] = *declaration.range;
        const double minimum = reading.parameter.minimum, maximum = reading.parameter.maximum;
        expect_whole(reading, low, minimum, "the minimum", std::floor(minimum));
        expect_whole(reading, high, maximum, "the maximum", std::ceil(maximum));
    }
    if (const auto step = reading.parameter.step) {
        expect_whole(reading, *declaration.step, *step, "the step", std::ceil(*step));
    }
}

void check_logarithmic(Reading& reading) {
    const ParameterDeclaration& declaration = reading.declaration;
    if (declaration.range && reading.parameter.minimum <= 0) {
        reading.fail(reading.lowering.span((*declaration.range)[0]),
                     fmt::format("the minimum {} of {} must be above 0; write for example 0.01",
                                 reading.parameter.minimum, named(declaration)));
    } else if (std::ranges::min(reading.parameter.initial) <= 0) {
        reading.fail(reading.lowering.span(declaration.initial),
                     fmt::format("the initial value of {} must be above 0", named(declaration)));
    }
}

/// The rules of each type, for values that are numbers.
void check_type(Reading& reading) {
    const ParameterDeclaration& declaration = reading.declaration;
    switch (declaration.type) {
        case Type::real:
        case Type::angle:
        case Type::choice:
        case Type::toggle:
            break;
        case Type::integer:
            return check_integer(reading);
        case Type::logarithmic:
            return check_logarithmic(reading);
        case Type::colour:
            if (reading.parameter.size() == 3) break;
            reading.fail(reading.lowering.span(declaration.initial),
                         fmt::format("the initial value of {} needs red, green and blue; write "
                                     "for example (1, 0.5, 0)",
                                     named(declaration)));
    }
}

void check_inside(Reading& reading) {
    const field::Parameter& parameter = reading.parameter;
    for (std::size_t i = 0; i < parameter.size(); ++i) {
        const double value = parameter.initial[i];
        if (value >= parameter.minimum && value <= parameter.maximum) continue;
        const std::string component =
            parameter.size() > 1 ? fmt::format("component {} of ", "xyzw"[i]) : "";
        reading.fail(
            reading.lowering.span(reading.declaration.initial),
            fmt::format("{}the initial value {} of '{}' is outside its range [{}, {}]", component,
                        value, parameter.name, parameter.minimum, parameter.maximum));
    }
}

/// Gives every component its parameter of the graph; the value that the name stands for.
Value add_to_graph(Reading& reading) {
    graph::Graph& graph = reading.lowering.field.graph;
    field::Parameter& parameter = reading.parameter;
    VectorValue vector{reading.algebra, {}};
    for (std::size_t i = 0; i < parameter.size(); ++i) {
        parameter.ids.push_back(graph.new_parameter(field::component_name(parameter, i)));
        vector.components.push_back(graph.parameter(parameter.ids.back()));
    }
    if (parameter.size() == 1) return vector.components.front();
    return vector;
}

}  // namespace

Value lower_parameter(Lowering& lowering, const ParameterDeclaration& declaration) {
    Reading reading{lowering, declaration};
    field::Parameter& parameter = reading.parameter;
    parameter.name = declaration.name;
    parameter.label = declaration.label.value_or(declaration.name);
    parameter.group = declaration.group.value_or("");
    parameter.tooltip = declaration.tooltip.value_or("");
    parameter.type = declaration.type;
    parameter.choices = declaration.choices;
    parameter.span = declaration.span;
    read_initial(reading);
    if (declaration.range) read_range(reading);
    if (declaration.step) read_step(reading);
    if (reading.good) check_type(reading);
    if (reading.good && !declaration.range) choose_range(reading);
    if (reading.good) check_inside(reading);
    if (!reading.good) return Nothing{};
    Value value = add_to_graph(reading);
    lowering.field.parameters.push_back(std::move(parameter));
    return value;
}

}  // namespace formula
