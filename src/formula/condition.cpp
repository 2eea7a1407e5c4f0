// SPDX-License-Identifier: MIT
#include "formula/condition.h"

#include <fmt/format.h>

#include <utility>

#include "graph/build.h"

namespace formula {
namespace {

using graph::NodeId;
using graph::Op;

/// Conditions joined by one operator; `\` takes the opposite of what follows.
std::optional<Condition> joined(Lowering& lowering, const std::vector<Operand>& operands,
                                Condition::Kind kind) {
    Condition result;
    result.kind = kind;
    for (const Operand& operand : operands) {
        std::optional<Condition> part = lower_condition(lowering, operand.expression);
        if (!part) continue;
        if (operand.joint == Joint::without) part->opposite = !part->opposite;
        result.parts.push_back(*std::move(part));
    }
    if (result.parts.size() < operands.size()) return std::nullopt;
    return result;
}

Condition compare(Relation relation, NodeId left, NodeId right) {
    return {Condition::Kind::comparison, relation, left, right, false, {}};
}

std::optional<Condition> from_value(Lowering& lowering, ExpressionId id) {
    const Value value = lower_expression(lowering, id);
    graph::Graph& graph = lowering.field.graph;
    if (const auto* number = std::get_if<NodeId>(&value)) {
        return compare(Relation::greater, *number, graph.constant(0.5));
    }
    if (const auto* solid = std::get_if<FieldValue>(&value)) {
        const auto* formula = std::get_if<field::Formula>(&lowering.field[solid->id]);
        if (formula) {
            const bool sheet = formula->kind == field::Kind::sheet;
            return compare(sheet ? Relation::equal : Relation::less_equal, formula->value,
                           graph.constant(0));
        }
    }
    if (!is_nothing(value) && !report_function(lowering, lowering.span(id), value)) {
        lowering.error(lowering.span(id),
                       fmt::format("{} cannot be a condition; write a comparison such as a < b",
                                   describe(value)));
    }
    return std::nullopt;
}

}  // namespace

std::optional<Condition> lower_condition(Lowering& lowering, ExpressionId id) {
    const ExpressionNode& node = lowering[id].node;
    if (const auto* it = std::get_if<Comparison>(&node)) {
        const auto left = as_number(lowering, it->left, "in a comparison", join_fields);
        const auto right = as_number(lowering, it->right, "in a comparison", join_fields);
        if (!left || !right) return std::nullopt;
        return compare(it->relation, *left, *right);
    }
    if (const auto* it = std::get_if<Intersection>(&node)) {
        return joined(lowering, it->operands, Condition::Kind::both);
    }
    if (const auto* it = std::get_if<Union>(&node)) {
        return joined(lowering, it->operands, Condition::Kind::either);
    }
    return from_value(lowering, id);
}

NodeId select(Lowering& lowering, const Condition& condition, NodeId yes, NodeId no) {
    if (condition.opposite) std::swap(yes, no);
    if (condition.kind != Condition::Kind::comparison) {
        const bool both = condition.kind == Condition::Kind::both;
        NodeId result = both ? yes : no;
        for (const Condition& part : condition.parts) {
            result =
                both ? select(lowering, part, result, no) : select(lowering, part, yes, result);
        }
        return result;
    }
    graph::Graph& graph = lowering.field.graph;
    const NodeId a = condition.left, b = condition.right;
    switch (condition.relation) {
        case Relation::less:
            return graph.apply(Op::select_less, a, b, yes, no);
        case Relation::greater:
            return graph.apply(Op::select_less, b, a, yes, no);
        case Relation::less_equal:
            return graph.apply(Op::select_less, b, a, no, yes);
        case Relation::greater_equal:
            return graph.apply(Op::select_less, a, b, no, yes);
        case Relation::equal:
            return graph.apply(Op::select_less, a, b, no,
                               graph.apply(Op::select_less, b, a, no, yes));
    }
    return no;
}

NodeId sign_of(Lowering& lowering, const Condition& condition) {
    graph::Graph& graph = lowering.field.graph;
    const bool strict = condition.kind == Condition::Kind::comparison && !condition.opposite;
    if (strict && condition.relation == Relation::greater) {
        return graph.apply(Op::sub, condition.left, condition.right);
    }
    if (strict && condition.relation == Relation::less) {
        return graph.apply(Op::sub, condition.right, condition.left);
    }
    return select(lowering, condition, graph.constant(1), graph.constant(-1));
}

}  // namespace formula
