// SPDX-License-Identifier: MIT
#include "formula/repeated_field.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "formula/apply.h"
#include "formula/arguments.h"
#include "formula/limits.h"

namespace formula {
namespace {

/// The second argument; 0 after an error.
std::size_t count_of(Lowering& lowering, const Call& call) {
    const ExpressionId id = call.arguments[1];
    const auto given = uniform_components(lowering, call, "n", id, 1);
    if (!given) return 0;
    const graph::NodeId number = folded(lowering, (*given)[0]);
    const graph::Graph& graph = lowering.field.graph;
    const double value = graph.is_constant(number) ? graph[number].value : 0;
    if (value >= 1 && value <= static_cast<double>(max_objects) && value == std::floor(value)) {
        return static_cast<std::size_t>(value);
    }
    lowering.error(lowering.span(id),
                   fmt::format("the argument 'n' of '{}' must be a whole number from 1 to 10,000, "
                               "the same for all parameters",
                               call.function));
    return 0;
}

}  // namespace

bool has_repeated_field(Lowering& lowering, const Call& call) {
    if (call.arguments.size() < 2) return false;
    const auto* name = std::get_if<Name>(&lowering[call.arguments[0]].node);
    const Binding* binding = name ? find_binding(lowering.scope, name->text) : nullptr;
    return binding && std::holds_alternative<FunctionValue>(binding->value);
}

std::optional<std::vector<FieldOperand>> repeated_field(Lowering& lowering, const Call& call) {
    const ExpressionId id = call.arguments[0];
    const std::size_t count = count_of(lowering, call);
    const auto function = as_function(lowering, id, "repeated");
    if (count == 0 || !function) return std::nullopt;
    std::vector<FieldOperand> operands;
    for (std::size_t i = 1; i <= count; ++i) {
        const graph::NodeId number = lowering.field.graph.constant(static_cast<double>(i));
        const Value value =
            apply(lowering, *function, lowering.span(id), std::array<Value, 1>{number});
        if (is_nothing(value)) return std::nullopt;
        const auto* field = std::get_if<FieldValue>(&value);
        if (!field) {
            lowering.error(lowering.span(id), fmt::format("'{}' must give a field for each number, "
                                                          "not {}",
                                                          function->name, describe(value)));
            return std::nullopt;
        }
        operands.push_back({*field, id});
        check_size(lowering, value, lowering.span(id));
        if (lowering.too_large) return std::nullopt;
    }
    return operands;
}

}  // namespace formula
