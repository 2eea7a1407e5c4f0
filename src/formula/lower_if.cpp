// SPDX-License-Identifier: MIT
// Lowers `if(condition, u, v)`.
#include <fmt/format.h>

#include "field/blends.h"
#include "formula/arithmetic.h"
#include "formula/condition.h"

namespace formula {
namespace {

using graph::NodeId;

/// What is known of both; where they are stretched differently the stretch is chosen too.
std::optional<Orbit> chosen_orbit(Lowering& lowering, const Condition& condition,
                                  const std::optional<Orbit>& a, const std::optional<Orbit>& b) {
    if (!a || !b || a->degree != b->degree) return std::nullopt;
    const auto choose = [&](NodeId yes, NodeId no) {
        return yes == no ? yes : select(lowering, condition, yes, no);
    };
    std::optional<NodeId> across;
    if (a->across || b->across) {
        across = choose(a->across.value_or(a->stretch), b->across.value_or(b->stretch));
    }
    return Orbit{choose(a->stretch, b->stretch), a->degree, choose(a->scale, b->scale), across};
}

Value choose_vector(Lowering& lowering, const Condition& condition, Algebra algebra,
                    const VectorValue& a, const VectorValue& b) {
    VectorValue result{algebra, {}, chosen_orbit(lowering, condition, a.orbit, b.orbit)};
    for (std::size_t i = 0; i < a.components.size(); ++i) {
        result.components.push_back(select(lowering, condition, a.components[i], b.components[i]));
    }
    return result;
}

Value choose_field(Lowering& lowering, const Call& call, const Condition& condition,
                   const FieldValue& a, const FieldValue& b) {
    graph::Graph& graph = lowering.field.graph;
    const NodeId sign = folded(lowering, sign_of(lowering, condition));
    // As the copies of a function have it, by their numbers.
    if (graph.is_constant(sign)) return graph[sign].value > 0 ? a : b;
    if (lowering.facts.depends_on_point(graph, sign)) {
        lowering.error(lowering.span(call.arguments[0]),
                       "the condition of 'if' between fields must be the same at every point; "
                       "write '(A & F) | (B \\ F)'");
        return Nothing{};
    }
    return FieldValue{field::choose(lowering.field, graph.constant(0), sign, a.id, b.id),
                      a.objects + b.objects};
}

}  // namespace

Value lower_if(Lowering& lowering, const Call& call) {
    if (call.arguments.size() != 3) {
        for (const ExpressionId id : call.arguments) lower_expression(lowering, id);
        lowering.error(call.name, fmt::format("'if' takes 3 arguments, not {}; write "
                                              "'if(a < b, u, v)'",
                                              call.arguments.size()));
        return Nothing{};
    }
    const std::optional<Condition> condition = lower_condition(lowering, call.arguments[0]);
    const Value yes = lower_expression(lowering, call.arguments[1]);
    const Value no = lower_expression(lowering, call.arguments[2]);
    if (report_function(lowering, lowering.span(call.arguments[1]), yes) ||
        report_function(lowering, lowering.span(call.arguments[2]), no)) {
        return Nothing{};
    }
    if (!condition || is_nothing(yes) || is_nothing(no)) return Nothing{};
    const auto *a = std::get_if<NodeId>(&yes), *b = std::get_if<NodeId>(&no);
    if (a && b) return select(lowering, *condition, *a, *b);
    const auto *u = std::get_if<VectorValue>(&yes), *v = std::get_if<VectorValue>(&no);
    if (u && v) {
        if (const std::optional<Algebra> algebra = common_algebra(*u, *v)) {
            return choose_vector(lowering, *condition, *algebra, *u, *v);
        }
    }
    if (std::holds_alternative<FieldValue>(yes) && std::holds_alternative<FieldValue>(no)) {
        return choose_field(lowering, call, *condition, std::get<FieldValue>(yes),
                            std::get<FieldValue>(no));
    }
    lowering.error(call.name, fmt::format("both choices of 'if' must be of one type, not {} and {}",
                                          describe(yes), describe(no)));
    return Nothing{};
}

}  // namespace formula
