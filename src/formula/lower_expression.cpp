// SPDX-License-Identifier: MIT
// Lowers expressions of numbers, and comparisons, which make fields of them.
#include <fmt/format.h>

#include <cassert>
#include <utility>

#include "formula/limits.h"
#include "formula/lowering.h"

namespace formula {
namespace {

using graph::NodeId;
using graph::Op;

std::string_view describe(const Lowering& lowering, ExpressionId id, const Value& value) {
    if (std::holds_alternative<VectorValue>(value)) return "a tuple";
    if (std::holds_alternative<Comparison>(lowering[id].node)) return "a comparison";
    return "a field";
}

Op operator_of(Joint joint) {
    switch (joint) {
        case Joint::plus:
            return Op::add;
        case Joint::minus:
            return Op::sub;
        case Joint::times:
        case Joint::implied_times:
            return Op::mul;
        case Joint::over:
            return Op::div;
        case Joint::both:
        case Joint::without:
        case Joint::either:
            break;
    }
    assert(false);
    return Op::add;
}

constexpr std::string_view in_arithmetic = "in arithmetic";

Value lower_chain(Lowering& lowering, const std::vector<Operand>& operands) {
    std::optional<NodeId> value;
    bool broken = false;
    for (const Operand& operand : operands) {
        const auto next = as_number(lowering, operand.expression, in_arithmetic);
        broken = broken || !next;
        if (broken) continue;
        value =
            value ? lowering.field.graph.apply(operator_of(operand.joint), *value, *next) : *next;
    }
    if (broken || !value) return Nothing{};
    return *value;
}

/// left - right, without the trivial half of `F = 0`.
NodeId difference(graph::Graph& graph, NodeId left, NodeId right) {
    if (graph.is_constant(right, 0)) return left;
    return graph.apply(Op::sub, left, right);
}

FieldValue compare(Lowering& lowering, Relation relation, NodeId left, NodeId right) {
    field::Formula formula;
    switch (relation) {
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
    return {lowering.field.add(formula), 1};
}

struct Visitor {
    Lowering& lowering;
    base::SourceSpan span;

    Value operator()(const Number& it) const { return lowering.field.graph.constant(it.value); }
    Value operator()(const Name& it) const { return lower_name(lowering, it.text, span); }
    Value operator()(const Negate& it) const {
        const auto operand = as_number(lowering, it.operand, in_arithmetic);
        if (!operand) return Nothing{};
        return lowering.field.graph.apply(Op::neg, *operand);
    }
    Value operator()(const Sum& it) const { return lower_chain(lowering, it.operands); }
    Value operator()(const Product& it) const { return lower_chain(lowering, it.operands); }
    Value operator()(const Power& it) const {
        const auto base = as_number(lowering, it.base, in_arithmetic);
        const auto exponent = as_number(lowering, it.exponent, in_arithmetic);
        if (!base || !exponent) return Nothing{};
        return lowering.field.graph.apply(Op::pow, *base, *exponent);
    }
    Value operator()(const Comparison& it) const {
        const auto left = as_number(lowering, it.left, "in a comparison");
        const auto right = as_number(lowering, it.right, "in a comparison");
        if (!left || !right) return Nothing{};
        return compare(lowering, it.relation, *left, *right);
    }
    Value operator()(const Tuple& it) const {
        VectorValue tuple;
        for (const ExpressionId part : it.parts) {
            const auto number = as_number(lowering, part, "in a tuple");
            if (number) tuple.components.push_back(*number);
        }
        if (tuple.components.size() < it.parts.size()) return Nothing{};
        return tuple;
    }
    Value operator()(const Intersection& it) const { return lower_intersection(lowering, it); }
    Value operator()(const Union& it) const { return lower_union(lowering, it); }
    Value operator()(const Call& it) const { return lower_call(lowering, it); }
    Value operator()(const Component&) const { return Nothing{}; }
    Value operator()(const Iterate&) const { return Nothing{}; }
    Value operator()(const Broken&) const { return Nothing{}; }
};

}  // namespace

std::size_t Lowering::line(base::SourceSpan span) const {
    return base::line_column(source->text, span.begin).line;
}

void Lowering::error(base::SourceSpan span, std::string message) {
    errors.push_back(base::error(span, std::move(message)));
}

void Lowering::warning(base::SourceSpan span, std::string message) {
    warnings.push_back(base::warning(span, std::move(message)));
}

void check_size(Lowering& lowering, const Value& value, base::SourceSpan span) {
    const auto* field = std::get_if<FieldValue>(&value);
    if (lowering.field.graph.size() > max_nodes) {
        static_assert(max_nodes == 20000);
        lowering.error(span, "the formula needs more than 20,000 operations; make it shorter");
        lowering.too_large = true;
    } else if ((field && field->objects > max_objects) ||
               lowering.field.nodes.size() > 4 * max_objects) {
        static_assert(max_objects == 10000);
        lowering.error(span, "the formula has more than 10,000 objects; make it shorter");
        lowering.too_large = true;
    }
}

Value lower_expression(Lowering& lowering, ExpressionId id) {
    if (lowering.too_large) return Nothing{};
    const Expression& expression = lowering[id];
    Value value = std::visit(Visitor{lowering, expression.span}, expression.node);
    if (lowering.too_large) return Nothing{};
    check_size(lowering, value, expression.span);
    if (lowering.too_large) return Nothing{};
    return value;
}

std::optional<graph::NodeId> as_number(Lowering& lowering, ExpressionId id,
                                       std::string_view where) {
    const Value value = lower_expression(lowering, id);
    if (const auto* number = std::get_if<NodeId>(&value)) return *number;
    if (std::holds_alternative<Nothing>(value)) return std::nullopt;
    const bool field = std::holds_alternative<FieldValue>(value);
    lowering.error(lowering.span(id),
                   fmt::format("{} cannot be used {}{}", describe(lowering, id, value), where,
                               field ? "; join fields with '|', '&' or '\\'" : ""));
    return std::nullopt;
}

std::optional<FieldValue> as_field(Lowering& lowering, ExpressionId id) {
    const Value value = lower_expression(lowering, id);
    if (const auto* field = std::get_if<FieldValue>(&value)) return *field;
    if (const auto* number = std::get_if<NodeId>(&value)) {
        const field::Formula sheet{*number, field::Metric::scalar, field::Kind::sheet};
        return FieldValue{lowering.field.add(sheet), 1};
    }
    if (std::holds_alternative<VectorValue>(value)) {
        lowering.error(lowering.span(id), "a tuple is no field; write an equation or a field");
    }
    return std::nullopt;
}

}  // namespace formula
