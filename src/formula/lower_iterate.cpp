// SPDX-License-Identifier: MIT
// Lowers iterations: the state, and one turn of it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "formula/built_in.h"
#include "formula/condition.h"
#include "formula/iteration_answers.h"
#include "formula/limits.h"
#include "formula/orbit.h"
#include "graph/build.h"

namespace formula {
namespace {

using graph::Expr;
using graph::NodeId;

/// A number, or the components of a vector; nothing else can be carried from turn to turn.
std::optional<std::vector<NodeId>> numbers_of(const Value& value) {
    if (const auto* number = std::get_if<NodeId>(&value)) return std::vector{*number};
    if (const auto* vector = std::get_if<VectorValue>(&value)) return vector->components;
    return std::nullopt;
}

bool is_vector(const Value& value) { return std::holds_alternative<VectorValue>(value); }

/// The number of turns, the same at every point and at most max_turns.
std::optional<NodeId> lower_limit(Lowering& lowering, ExpressionId id) {
    const std::optional<NodeId> limit = as_number(lowering, id, "as the number of turns");
    if (!limit) return std::nullopt;
    graph::Graph& graph = lowering.field.graph;
    const base::SourceSpan span = lowering.span(id);
    if (lowering.facts.depends_on_point(graph, *limit)) {
        lowering.error(span, "the number of turns must not depend on x, y or z");
        return std::nullopt;
    }
    const std::optional<double> known = lowering.facts.constant(graph, *limit);
    if (!known) return min(Expr(graph, *limit), static_cast<double>(max_turns)).id;
    if (!(*known >= 0)) {
        lowering.error(span, "the number of turns is 0 or more");
        return std::nullopt;
    }
    if (*known > max_turns) {
        static_assert(max_turns == 10000);
        lowering.error(span, "an iteration has at most 10,000 turns");
        return std::nullopt;
    }
    return limit;
}

bool asks_for_equality(const Condition& condition) {
    if (condition.kind == Condition::Kind::comparison) {
        return condition.relation == Relation::equal;
    }
    return std::ranges::any_of(condition.parts, asks_for_equality);
}

class IterateLowering {
public:
    IterateLowering(Lowering& lowering, const Iterate& iterate, base::SourceSpan span)
        : lowering_(lowering), iterate_(iterate), span_(span) {}

    Value lower() {
        std::vector<Value> starts;
        for (const Assignment& it : iterate_.state) {
            starts.push_back(lower_expression(lowering_, it.value));
        }
        const std::optional<NodeId> limit = lower_limit(lowering_, iterate_.limit);
        if (limit) turns_.iteration.limit = *limit;
        turns_.failed = !limit;
        InnerScope scope(lowering_);
        scope.names.iteration = &iterate_;
        name_turns();
        for (std::size_t i = 0; i < starts.size(); ++i) add_state(i, starts[i]);
        if (iterate_.until) lower_until();
        lower_turn();
        add_variable(turns_.done, graph().constant(0),
                     (Expr(graph(), graph().variable(turns_.done)) + 1.0).id);
        return lower_answers(lowering_, iterate_, std::move(turns_), span_);
    }

private:
    graph::Graph& graph() { return lowering_.field.graph; }

    void add_variable(graph::VariableId id, NodeId start, NodeId step) {
        turns_.iteration.state.push_back(id);
        turns_.iteration.start.push_back(start);
        turns_.iteration.step.push_back(step);
    }

    /// `i`, unless the text gives that a meaning.
    void name_turns() {
        turns_.done = graph().new_variable("turns");
        if (find_binding(lowering_.scope, "i")) return;
        lowering_.scope->set("i", graph().variable(turns_.done), span_, Role::state);
    }

    bool may_name(const Assignment& assignment) {
        if (!is_coordinate(assignment.name)) return true;
        lowering_.error(assignment.span, fmt::format("'{}' is a coordinate and cannot be redefined",
                                                     assignment.name));
        turns_.failed = true;
        return false;
    }

    void add_state(std::size_t i, const Value& start) {
        const Assignment& declared = iterate_.state[i];
        const auto numbers = numbers_of(start);
        if (!numbers && !is_nothing(start)) {
            lowering_.error(lowering_.span(declared.value),
                            fmt::format("'{}' must be a number or a vector, not {}", declared.name,
                                        describe(start)));
        }
        turns_.failed = turns_.failed || !numbers;
        Value value;
        if (may_name(declared) && numbers) value = state(i, start, *numbers);
        lowering_.scope->set(declared.name, std::move(value), declared.span, Role::state);
    }

    /// Variables in the form of the start; of the orbit it is known how it grows with itself.
    Value state(std::size_t i, const Value& start, std::span<const NodeId> numbers) {
        const std::string& name = iterate_.state[i].name;
        std::vector<NodeId> variables;
        first_.push_back(turns_.iteration.state.size());
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            const graph::VariableId id = graph().new_variable(
                is_vector(start) ? fmt::format("{}.{}", name, "xyzw"[k]) : name);
            variables.push_back(graph().variable(id));
            // Stays as it is, until the turn says otherwise.
            add_variable(id, numbers[k], variables.back());
        }
        const auto* vector = std::get_if<VectorValue>(&start);
        Value value = variables[0];
        if (vector) value = VectorValue{vector->algebra, variables, std::nullopt};
        if (i > 0) return value;
        turns_.growth = graph().new_variable("growth");
        if (vector) {
            const NodeId one = graph().constant(1);
            Orbit orbit{graph().variable(turns_.growth), one, one};
            if (vector->algebra == Algebra::triplex) {
                turns_.across = graph().new_variable("across");
                orbit.across = graph().variable(turns_.across);
            }
            std::get<VectorValue>(value).orbit = orbit;
            turns_.start = orbit_of(lowering_, *vector);
        }
        turns_.orbit = value;
        return value;
    }

    void lower_until() {
        const base::SourceSpan span = lowering_.span(*iterate_.until);
        const std::optional<Condition> condition = lower_condition(lowering_, *iterate_.until);
        turns_.failed = turns_.failed || !condition;
        if (!condition) return;
        if (asks_for_equality(*condition)) {
            lowering_.error(span, "numbers are seldom equal; end an iteration by '<' or '>'");
            turns_.failed = true;
        } else if (condition->kind != Condition::Kind::comparison || condition->opposite) {
            turns_.until = {sign_of(lowering_, *condition), graph().constant(0), span};
        } else if (condition->relation == Relation::less ||
                   condition->relation == Relation::less_equal) {
            turns_.until = {condition->right, condition->left, span};
        } else {
            turns_.until = {condition->left, condition->right, span};
        }
    }

    void lower_turn() {
        InnerScope turn(lowering_);
        for (const Assignment& it : iterate_.body) {
            Value value = lower_expression(lowering_, it.value);
            if (may_name(it)) turn.names.set(it.name, std::move(value), it.span, Role::state);
        }
        for (std::size_t i = 0; i < iterate_.state.size(); ++i) {
            const auto found = turn.names.names.find(iterate_.state[i].name);
            if (found != turn.names.names.end()) set_step(i, found->second);
        }
    }

    void set_step(std::size_t i, const Binding& next) {
        const Assignment& declared = iterate_.state[i];
        const Value& before = find_binding(lowering_.scope->outer, declared.name)->value;
        turns_.failed = turns_.failed || is_nothing(next.value);
        if (turns_.failed) return;
        const auto numbers = numbers_of(next.value);
        const auto variables = numbers_of(before);
        if (!numbers || is_vector(next.value) != is_vector(before) ||
            numbers->size() != variables->size()) {
            lowering_.error(next.span,
                            fmt::format("'{}' begins as {} and cannot become {}", declared.name,
                                        describe(before), describe(next.value)));
            turns_.failed = true;
            return;
        }
        for (std::size_t k = 0; k < numbers->size(); ++k) {
            turns_.iteration.step[first_[i] + k] = (*numbers)[k];
        }
        const auto* vector = std::get_if<VectorValue>(&next.value);
        if (i == 0 && vector) turns_.next = orbit_of(lowering_, *vector);
    }

    Lowering& lowering_;
    const Iterate& iterate_;
    base::SourceSpan span_;
    Turns turns_{};
    std::vector<std::size_t> first_{};  ///< of each name that is carried, the first of its numbers
};

}  // namespace

Value lower_iterate(Lowering& lowering, const Iterate& iterate, base::SourceSpan span) {
    return IterateLowering(lowering, iterate, span).lower();
}

}  // namespace formula
