// SPDX-License-Identifier: MIT
// Lowers comparisons, which make fields of numbers.
#include <fmt/format.h>

#include "formula/lowering.h"

namespace formula {
namespace {

using graph::NodeId;
using graph::Op;

/// left - right, without the trivial half of `F = 0`.
NodeId difference(graph::Graph& graph, NodeId left, NodeId right) {
    if (graph.is_constant(right, 0)) return left;
    return graph.apply(Op::sub, left, right);
}

FieldValue compare(Lowering& lowering, const Comparison& comparison, NodeId left, NodeId right) {
    field::Formula formula;
    switch (comparison.relation) {
        case Relation::equal:
            formula.kind = field::Kind::sheet;
            formula.value = difference(lowering.field.graph, left, right);
            break;
        case Relation::less_equal:
        case Relation::less:
            formula.value = difference(lowering.field.graph, left, right);
            break;
        case Relation::greater_equal:
        case Relation::greater:
            formula.value = difference(lowering.field.graph, right, left);
            break;
    }
    const field::FieldId id = lowering.field.add(formula);
    // In the body of a function another call may make something else of it.
    if (!lowering.source->library && !lowering.frame) {
        lowering.comparisons[id] =
            base::cover(lowering.span(comparison.left), lowering.span(comparison.right));
    }
    return {id, 1};
}

/// The value of a field that stands in an equation: a number is meant, and the surface alone.
std::optional<NodeId> value_of_field(Lowering& lowering, const FieldValue& field,
                                     base::SourceSpan span) {
    const auto* formula = std::get_if<field::Formula>(&lowering.field[field.id]);
    if (!formula || formula->kind == field::Kind::sheet) return std::nullopt;
    lowering.warning(span,
                     "an equation makes a sheet of this solid: its surface alone, without an "
                     "inside; leave the equation away for the solid");
    return formula->value;
}

/// One side of a comparison. `equation`: a solid of one formula may stand there as well.
std::optional<NodeId> side(Lowering& lowering, ExpressionId id, bool equation) {
    constexpr std::string_view where = "in a comparison";
    const ExpressionNode& node = lowering[id].node;
    const bool solid = std::holds_alternative<Call>(node) || std::holds_alternative<Name>(node);
    if (!equation || !solid) return as_number(lowering, id, where, join_fields);
    const Value value = lower_expression(lowering, id);
    if (const auto* field = std::get_if<FieldValue>(&value)) {
        if (const auto number = value_of_field(lowering, *field, lowering.span(id))) return number;
    }
    return number_of(lowering, id, value, where, join_fields);
}

}  // namespace

Value lower_comparison(Lowering& lowering, const Comparison& comparison) {
    const bool equation = comparison.relation == Relation::equal;
    const auto left = side(lowering, comparison.left, equation);
    const auto right = side(lowering, comparison.right, equation);
    if (!left || !right) return Nothing{};
    return compare(lowering, comparison, *left, *right);
}

}  // namespace formula
