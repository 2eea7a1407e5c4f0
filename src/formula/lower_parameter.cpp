// SPDX-License-Identifier: MIT
// Lowers the declaration of a parameter.
#include <fmt/format.h>

#include <cmath>

#include "formula/lowering.h"

namespace formula {
namespace {

/// The value of an expression of constants; an error otherwise. `what` begins the sentence.
std::optional<double> constant(Lowering& lowering, ExpressionId id, const std::string& what) {
    const auto number = as_number(lowering, id, "as a value of a parameter");
    if (!number) return std::nullopt;
    const std::optional<double> value = lowering.facts.constant(lowering.field.graph, *number);
    if (!value) {
        lowering.error(lowering.span(id),
                       fmt::format("{} must be a constant; it cannot depend on the point, the time "
                                   "or another parameter",
                                   what));
        return std::nullopt;
    }
    if (!std::isfinite(*value)) {
        lowering.error(lowering.span(id), fmt::format("{} is not a finite number", what));
        return std::nullopt;
    }
    return value;
}

void choose_range(field::Parameter& parameter) {
    const double value = parameter.initial;
    parameter.minimum = value < 0 ? 2 * value : value == 0 ? -1 : 0;
    parameter.maximum = value < 0 ? 0 : value == 0 ? 1 : 2 * value;
}

/// True if the range is good; reports what is not.
bool read_range(Lowering& lowering, const ParameterDeclaration& declaration,
                field::Parameter& parameter) {
    const std::string of = fmt::format("of '{}'", declaration.name);
    const auto [low, high] = *declaration.range;
    const auto minimum = constant(lowering, low, "the minimum " + of);
    const auto maximum = constant(lowering, high, "the maximum " + of);
    if (!minimum || !maximum) return false;
    parameter.minimum = *minimum;
    parameter.maximum = *maximum;
    const base::SourceSpan span = base::cover(lowering.span(low), lowering.span(high));
    if (*minimum >= *maximum) {
        lowering.error(span,
                       fmt::format("the range {} is empty; write the smaller number first", of));
        return false;
    }
    return true;
}

bool read_step(Lowering& lowering, const ParameterDeclaration& declaration,
               field::Parameter& parameter) {
    const std::string what = fmt::format("the step of '{}'", declaration.name);
    parameter.step = constant(lowering, *declaration.step, what);
    if (parameter.step && *parameter.step <= 0) {
        lowering.error(lowering.span(*declaration.step), what + " must be above 0");
        return false;
    }
    return parameter.step.has_value();
}

}  // namespace

std::optional<field::Parameter> lower_parameter(Lowering& lowering,
                                                const ParameterDeclaration& declaration) {
    field::Parameter parameter;
    parameter.name = declaration.name;
    parameter.label = declaration.label.value_or(declaration.name);
    parameter.span = declaration.span;
    const auto initial = constant(lowering, declaration.initial,
                                  fmt::format("the initial value of '{}'", declaration.name));
    parameter.initial = initial.value_or(0);
    if (!declaration.range) choose_range(parameter);
    const bool range = !declaration.range || read_range(lowering, declaration, parameter);
    const bool step = !declaration.step || read_step(lowering, declaration, parameter);
    if (!initial || !range || !step) return std::nullopt;
    if (*initial < parameter.minimum || *initial > parameter.maximum) {
        lowering.error(
            lowering.span(declaration.initial),
            fmt::format("the initial value {} of '{}' is outside its range [{}, {}]", *initial,
                        declaration.name, parameter.minimum, parameter.maximum));
        return std::nullopt;
    }
    parameter.id = lowering.field.graph.new_parameter(declaration.name);
    return parameter;
}

}  // namespace formula
