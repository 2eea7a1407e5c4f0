// SPDX-License-Identifier: MIT
#include "shader/domain.h"

#include <algorithm>
#include <array>
#include <limits>

#include "passes/spell_out_lengths.h"

namespace shader {
namespace {

using graph::Op;

bool is_partial(Op op) {
    constexpr std::array partial{Op::div, Op::pow, Op::sqrt, Op::log, Op::asin, Op::acos, Op::tan};
    return std::ranges::find(partial, op) != partial.end();
}

bool is_broken(Op op) {
    constexpr std::array broken{Op::sign,  Op::floor,       Op::ceil,  Op::atan2,
                                Op::ratio, Op::select_less, Op::abs,   Op::min,
                                Op::max,   Op::cbrt,        Op::hypot, Op::hypot3};
    return std::ranges::find(broken, op) != broken.end();
}

/// The reciprocal that a division by a parameter has become (passes/divide_by_constants.h), which
/// may be infinite.
bool is_reciprocal(const graph::Graph& graph, graph::NodeId id) {
    const graph::Node& node = graph[id];
    if (node.op == Op::div) return graph.is_constant(node.arguments[0], 1);
    return (node.op == Op::mul || node.op == Op::neg) &&
           std::ranges::any_of(node.args(), [&](auto a) { return is_reciprocal(graph, a); });
}

/// At least the value that the node has at every point, if that is above 0; otherwise 0.
double positive_bound(const graph::Graph& graph, graph::NodeId id) {
    const graph::Node& node = graph[id];
    if (node.op == Op::constant) return std::max(node.value, 0.0);
    if (node.op != Op::max) return 0;
    return std::max(positive_bound(graph, node.arguments[0]),
                    positive_bound(graph, node.arguments[1]));
}

/// Whether the operator is NaN for some arguments that are finite.
bool is_nan_somewhere(const graph::Graph& graph, const graph::Node& node) {
    if (!is_partial(node.op)) return node.op == Op::constant && node.value != node.value;
    if (node.op == Op::sqrt) return !passes::is_sum_of_squares(graph, node.arguments[0]);
    if (node.op != Op::div) return true;
    const graph::NodeId divisor = node.arguments[1];
    const bool never_zero = graph.is_constant(divisor) && !graph.is_constant(divisor, 0);
    return !never_zero && positive_bound(graph, divisor) < std::numeric_limits<float>::min();
}

}  // namespace

bool may_be_undefined(const graph::Graph& graph, std::span<const graph::NodeId> roots) {
    const std::vector<bool> depends = depends_on_variables(graph);
    return std::ranges::any_of(reachable(graph, roots), [&](graph::NodeId id) {
        // A parameter's expression may be undefined as well, but then it is so everywhere.
        const graph::Node& node = graph[id];
        if (!depends[index(id)]) return false;
        if (node.op == Op::mul) {
            return std::ranges::any_of(node.args(), [&](graph::NodeId a) {
                return !depends[index(a)] && is_reciprocal(graph, a);
            });
        }
        if (!is_partial(node.op)) return false;
        // A constant divisor other than 0 never fails.
        return node.op != Op::div || !graph.is_constant(node.arguments[1]) ||
               graph.is_constant(node.arguments[1], 0);
    });
}

std::vector<bool> may_be_nan(const field::Field& field) {
    const graph::Graph& graph = field.graph;
    std::vector<bool> carried(graph.variable_count(), false);  // of the state of iterations
    for (const field::Node& node : field.nodes) {
        if (!std::holds_alternative<field::Blend>(node)) continue;
        for (const graph::VariableId value : std::get<field::Blend>(node).values) {
            carried[graph::index(value)] = true;
        }
    }
    for (;;) {
        std::vector<bool> may(graph.size());
        for (std::size_t i = 0; i < may.size(); ++i) {
            const graph::Node& node = graph[static_cast<graph::NodeId>(i)];
            may[i] = (node.op == Op::variable && carried[node.symbol]) ||
                     is_nan_somewhere(graph, node) ||
                     std::ranges::any_of(node.args(), [&](auto a) { return may[index(a)]; });
        }
        bool more = false;
        for (const field::Node& node : field.nodes) {
            const auto* iteration = std::get_if<field::Iteration>(&node);
            for (std::size_t i = 0; iteration && i < iteration->state.size(); ++i) {
                const bool now = may[index(iteration->start[i])] || may[index(iteration->step[i])];
                const std::size_t variable = graph::index(iteration->state[i]);
                if (!now || carried[variable]) continue;
                carried[variable] = true;
                more = true;
            }
        }
        if (!more) return may;
    }
}

bool may_break(const graph::Graph& graph, std::span<const graph::NodeId> roots) {
    const std::vector<bool> depends = depends_on_variables(graph);
    return std::ranges::any_of(reachable(graph, roots), [&](graph::NodeId id) {
        return depends[index(id)] && is_broken(graph[id].op);
    });
}

}  // namespace shader
