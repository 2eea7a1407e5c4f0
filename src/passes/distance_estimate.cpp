// SPDX-License-Identifier: MIT
#include "passes/distance_estimate.h"

#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>

#include "graph/build.h"
#include "passes/depends_on.h"
#include "passes/dual_numbers.h"
#include "passes/spell_out_lengths.h"

namespace passes {
namespace {

using field::Iteration;
using graph::Expr;
using graph::Graph;
using graph::NodeId;
using graph::VariableId;

/// Adds a variable to the state; its step, which may need it, is to be added after it.
VariableId add_state(Graph& graph, Iteration& iteration, std::string name, NodeId start) {
    const VariableId id = graph.new_variable(std::move(name));
    iteration.state.push_back(id);
    iteration.start.push_back(start);
    return id;
}

/// A number that is `end` after the limit of turns, and grows by `factor` at each.
Expr backwards_from(Graph& graph, Iteration& iteration, std::string name, Expr end, Expr factor) {
    const Expr limit(graph, iteration.limit);
    const VariableId id =
        add_state(graph, iteration, std::move(name), (end * pow(factor, -limit)).id);
    const Expr value(graph, graph.variable(id));
    iteration.step.push_back((factor * value).id);
    return value;
}

/// What a number is multiplied by at each turn: the square, and how many roots that saves.
struct Factor {
    NodeId square{};
    int roots = 0;
};

/// The square of what does not hold the variable; of lengths that of what is under the root.
Factor squared(Graph& graph, NodeId id) {
    const graph::Node node = graph[id];
    const auto [a, b, c, d] = node.arguments;
    if (node.op == graph::Op::mul) {
        const Factor left = squared(graph, a), right = squared(graph, b);
        return {graph.apply(node.op, left.square, right.square), left.roots + right.roots};
    }
    if (node.op == graph::Op::sqrt && is_sum_of_squares(graph, a)) return {a, 1};
    const NodeId spelt = spell_out_lengths(graph, id);
    if (spelt != id) return squared(graph, spelt);
    return {graph.apply(graph::Op::mul, id, id), 0};
}

/// The factor if the number is only multiplied; none otherwise.
std::optional<Factor> factor_of(Graph& graph, NodeId step, VariableId variable) {
    const graph::Node node = graph[step];
    if (node.op != graph::Op::mul) return std::nullopt;
    for (const std::size_t k : {0U, 1U}) {
        const NodeId mine = node.arguments[k], other = node.arguments[1 - k];
        if (depends_on(graph, other, std::array{variable})) continue;
        const Factor factor = squared(graph, other);
        if (mine == graph.variable(variable)) return factor;
        const std::optional<Factor> rest = factor_of(graph, mine, variable);
        if (!rest) return std::nullopt;
        return Factor{graph.apply(graph::Op::mul, factor.square, rest->square),
                      factor.roots + rest->roots};
    }
    return std::nullopt;
}

/// The part of a node's order that its operator gives; none if it grows like no power.
std::optional<double> order_of(const Graph& graph, const graph::Node& node,
                               std::span<const double> of) {
    using graph::Op;
    switch (node.op) {
        case Op::constant:
        case Op::parameter:
        case Op::variable:
        case Op::sin:
        case Op::cos:
        case Op::asin:
        case Op::acos:
        case Op::atan:
        case Op::atan2:
        case Op::tanh:
        case Op::ratio:
        case Op::sign:
            return 0;
        case Op::neg:
        case Op::abs:
        case Op::floor:
        case Op::ceil:
            return of[0];
        case Op::add:
        case Op::sub:
        case Op::min:
        case Op::max:
        case Op::hypot:
        case Op::hypot3:
            return std::ranges::max(of);
        case Op::select_less:
            return std::max(of[2], of[3]);
        case Op::mul:
            return of[0] + of[1];
        case Op::div:
            return of[0] - of[1];
        case Op::sqrt:
            return of[0] / 2;
        case Op::cbrt:
            return of[0] / 3;
        case Op::pow:
            if (graph.is_constant(node.arguments[1])) {
                return of[0] * graph[node.arguments[1]].value;
            }
            break;
        case Op::tan:
        case Op::sinh:
        case Op::cosh:
        case Op::exp:
        case Op::log:
            break;
    }
    if (std::ranges::all_of(of, [](double order) { return order == 0; })) return 0;
    return std::nullopt;
}

}  // namespace

NodeId add_growth(Graph& graph, Iteration& iteration, const RunningDerivative& derivative) {
    const std::optional<Factor> factor = factor_of(graph, derivative.step, derivative.variable);
    if (factor && factor->roots > 0) {
        const VariableId square =
            add_state(graph, iteration, "growth squared",
                      (Expr(graph, derivative.start) * Expr(graph, derivative.start)).id);
        const Expr value(graph, graph.variable(square));
        iteration.step.push_back((Expr(graph, factor->square) * value).id);
        return sqrt(value).id;
    }
    iteration.state.push_back(derivative.variable);
    iteration.start.push_back(derivative.start);
    iteration.step.push_back(derivative.step);
    return graph.variable(derivative.variable);
}

NodeId add_jacobian_norm(Graph& graph, Iteration& iteration, std::size_t orbit_size) {
    std::vector<NodeId> orbit;
    for (std::size_t i = 0; i < orbit_size; ++i) {
        orbit.push_back(graph.variable(iteration.state[i]));
    }
    const std::vector<std::array<NodeId, 3>> rows = add_derivatives(graph, iteration, orbit);
    std::optional<Expr> squares;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const auto& row : rows) {
            if (graph.is_constant(row[axis], 0)) continue;
            const Expr entry(graph, row[axis]);
            squares = squares ? *squares + entry * entry : entry * entry;
        }
    }
    return squares ? sqrt(*squares).id : graph.constant(0);
}

NodeId distance_estimate(Graph& graph, Iteration& iteration, NodeId orbit_length,
                         const Escape& escape, NodeId growth) {
    const Expr length(graph, orbit_length), stretch(graph, growth);
    const Expr size = escape.by_power ? log(length) : length;
    Expr beyond = size;
    if (escape.rate) {
        const Expr rate(graph, *escape.rate), radius(graph, escape.radius);
        beyond = size - (escape.by_power
                             ? backwards_from(graph, iteration, "potential", log(radius), rate)
                             : backwards_from(graph, iteration, "radius left", radius, abs(rate)));
    }
    return ((escape.by_power ? 0.5 * length * beyond : beyond) / stretch).id;
}

std::optional<double> heuristic_order(const Graph& graph, NodeId root,
                                      std::span<const VariableId> state) {
    std::unordered_map<NodeId, double> orders;
    for (const NodeId id : reachable(graph, std::array{root})) {
        const graph::Node& node = graph[id];
        std::vector<double> of;
        for (const NodeId argument : node.args()) of.push_back(orders.at(argument));
        const bool is_state =
            node.op == graph::Op::variable &&
            std::ranges::find(state, static_cast<VariableId>(node.symbol)) != state.end();
        const std::optional<double> order = is_state ? 1 : order_of(graph, node, of);
        if (!order) return std::nullopt;
        orders[id] = *order;
    }
    return orders.at(root);
}

}  // namespace passes
