// SPDX-License-Identifier: MIT
// Lowers expressions of numbers, and comparisons, which make fields of them.
#include <fmt/format.h>

#include <utility>

#include "formula/arithmetic.h"
#include "formula/limits.h"
#include "formula/lowering.h"

namespace formula {
namespace {

using graph::NodeId;

/// What stands where only something else can, in words.
std::string describe(const Lowering& lowering, ExpressionId id, const Value& value) {
    const bool field = std::holds_alternative<FieldValue>(value);
    if (field && std::holds_alternative<Comparison>(lowering[id].node)) return "a comparison";
    return describe(value);
}

constexpr std::string_view in_arithmetic = "in arithmetic";

Value lower_chain(Lowering& lowering, const std::vector<Operand>& operands) {
    Value value;
    bool broken = false;
    base::SourceSpan span = lowering.span(operands.front().expression);
    for (const Operand& operand : operands) {
        const auto next = as_operand(lowering, operand.expression, in_arithmetic);
        broken = broken || !next;
        if (broken) continue;
        span = base::cover(span, lowering.span(operand.expression));
        const bool first = &operand == &operands.front();
        value = first ? *next : combine(lowering, operand.joint, span, value, *next);
        broken = is_nothing(value);
    }
    if (broken) return Nothing{};
    return value;
}

struct Visitor {
    Lowering& lowering;
    base::SourceSpan span;

    Value operator()(const Number& it) const { return lowering.field.graph.constant(it.value); }
    Value operator()(const Name& it) const { return lower_name(lowering, it.text, span); }
    Value operator()(const Negate& it) const {
        const auto operand = as_operand(lowering, it.operand, in_arithmetic);
        if (!operand) return Nothing{};
        return negative(lowering, *operand);
    }
    Value operator()(const Sum& it) const { return lower_chain(lowering, it.operands); }
    Value operator()(const Product& it) const { return lower_chain(lowering, it.operands); }
    Value operator()(const Power& it) const {
        const auto base = as_operand(lowering, it.base, in_arithmetic);
        const auto exponent = as_operand(lowering, it.exponent, in_arithmetic);
        if (!base || !exponent) return Nothing{};
        return raise(lowering, span, *base, *exponent);
    }
    Value operator()(const Comparison& it) const { return lower_comparison(lowering, it); }
    Value operator()(const Tuple& it) const {
        VectorValue tuple;
        for (const ExpressionId part : it.parts) {
            const auto number = as_number(lowering, part, "in a tuple");
            if (number) tuple.components.push_back(*number);
        }
        if (tuple.components.size() < it.parts.size()) return Nothing{};
        if (tuple.components.size() > 4) {
            lowering.error(span, "a vector has at most four components");
            return Nothing{};
        }
        return tuple;
    }
    Value operator()(const Intersection& it) const { return lower_intersection(lowering, it); }
    Value operator()(const Union& it) const { return lower_union(lowering, it); }
    Value operator()(const Call& it) const { return lower_call(lowering, it); }
    Value operator()(const Component& it) const { return lower_component(lowering, it); }
    Value operator()(const Iterate& it) const { return lower_iterate(lowering, it, span); }
    Value operator()(const Broken&) const { return Nothing{}; }
};

/// Reports a limit that is exceeded at the outermost call that leads there.
void stop(Lowering& lowering, base::SourceSpan span, std::string message) {
    for (const Frame* it = lowering.frame; it; it = it->outer) span = it->call;
    lowering.errors.push_back(base::error(span, std::move(message)));
    lowering.too_large = true;
}

/// Functions can make a short text long and high.
void check_expansion(Lowering& lowering, base::SourceSpan span) {
    if (++lowering.expressions > max_expansions) {
        static_assert(max_expansions == 200000);
        stop(lowering, span,
             "the formula has more than 200,000 expressions where its functions are put in; call "
             "them less often");
    } else if (lowering.depth >= max_depth) {
        static_assert(max_depth == 1500);
        stop(lowering, span, "the bodies of functions nest more than 1500 levels deep");
    } else if (lowering.frame && lowering.frame->level > max_calls) {
        static_assert(max_calls == 100);
        stop(lowering, span, "the calls of functions nest more than 100 levels deep");
    }
}

}  // namespace

void check_size(Lowering& lowering, const Value& value, base::SourceSpan span) {
    const auto* field = std::get_if<FieldValue>(&value);
    if (lowering.field.graph.size() > max_nodes) {
        static_assert(max_nodes == 100000);
        stop(lowering, span, "the formula needs more than 100,000 operations; make it shorter");
    } else if ((field && field->objects > max_objects) ||
               lowering.field.nodes.size() > 4 * max_objects) {
        static_assert(max_objects == 10000);
        stop(lowering, span, "the formula has more than 10,000 objects; make it shorter");
    }
}

Value lower_expression(Lowering& lowering, ExpressionId id) {
    if (lowering.too_large) return Nothing{};
    const Expression& expression = lowering[id];
    check_expansion(lowering, expression.span);
    ++lowering.depth;
    Value value = lowering.too_large
                      ? Value(Nothing{})
                      : std::visit(Visitor{lowering, expression.span}, expression.node);
    --lowering.depth;
    if (lowering.too_large) return Nothing{};
    check_size(lowering, value, expression.span);
    if (lowering.too_large) return Nothing{};
    return value;
}

std::optional<Value> as_operand(Lowering& lowering, ExpressionId id, std::string_view where) {
    Value value = lower_expression(lowering, id);
    if (std::holds_alternative<VectorValue>(value)) return value;
    if (const auto number = number_of(lowering, id, value, where, join_fields)) return *number;
    return std::nullopt;
}

std::optional<NodeId> number_of(Lowering& lowering, ExpressionId id, const Value& value,
                                std::string_view where, std::string_view with_field) {
    if (const auto* number = std::get_if<NodeId>(&value)) return *number;
    if (is_nothing(value) || report_function(lowering, lowering.span(id), value)) {
        return std::nullopt;
    }
    const bool field = std::holds_alternative<FieldValue>(value);
    lowering.error(
        lowering.span(id),
        fmt::format("{} cannot be used {}; {}", describe(lowering, id, value), where,
                    field ? with_field : "take its length(…) or a component such as .x"));
    return std::nullopt;
}

std::optional<NodeId> as_number(Lowering& lowering, ExpressionId id, std::string_view where,
                                std::string_view with_field) {
    return number_of(lowering, id, lower_expression(lowering, id), where, with_field);
}

std::optional<FieldValue> as_field(Lowering& lowering, ExpressionId id) {
    const Value value = lower_expression(lowering, id);
    if (const auto* field = std::get_if<FieldValue>(&value)) return *field;
    if (const auto* number = std::get_if<NodeId>(&value)) {
        const field::Formula sheet{*number, field::Metric::scalar, field::Kind::sheet};
        return FieldValue{lowering.field.add(sheet), 1};
    }
    if (!is_nothing(value) && !report_function(lowering, lowering.span(id), value)) {
        lowering.error(
            lowering.span(id),
            fmt::format("{} is no field; write an equation or a field", describe(value)));
    }
    return std::nullopt;
}

NodeId folded(Lowering& lowering, NodeId id) {
    const std::optional<double> known = lowering.facts.constant(lowering.field.graph, id);
    return known ? lowering.field.graph.constant(*known) : id;
}

}  // namespace formula
