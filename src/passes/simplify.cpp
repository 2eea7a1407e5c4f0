// SPDX-License-Identifier: MIT
#include "passes/simplify.h"

#include <algorithm>
#include <array>

namespace passes {
namespace {

using graph::Graph;
using graph::Node;
using graph::NodeId;
using graph::Op;

NodeId argument(const Graph& graph, NodeId id, std::size_t i) { return graph[id].arguments[i]; }
bool is(const Graph& graph, NodeId id, Op op) { return graph[id].op == op; }

template <std::size_t size>
bool is_one_of(const Graph& graph, NodeId id, const std::array<Op, size>& list) {
    return std::ranges::count(list, graph[id].op) > 0;
}

constexpr std::array odd{Op::sin,  Op::tan,  Op::asin, Op::atan,
                         Op::sinh, Op::tanh, Op::cbrt, Op::sign};
constexpr std::array even{Op::abs, Op::cos, Op::cosh};
constexpr std::array whole{Op::floor, Op::ceil, Op::sign};
/// Never below 0 where they are defined.
constexpr std::array not_negative{Op::abs, Op::sqrt, Op::exp, Op::cosh, Op::hypot, Op::hypot3};

NodeId sum(Graph& graph, NodeId id, NodeId a, NodeId b) {
    if (graph.is_constant(b, 0)) return a;
    if (graph.is_constant(a, 0)) return b;
    if (is(graph, b, Op::neg)) return graph.apply(Op::sub, a, argument(graph, b, 0));
    if (is(graph, a, Op::neg)) return graph.apply(Op::sub, b, argument(graph, a, 0));
    return id;
}

NodeId difference(Graph& graph, NodeId id, NodeId a, NodeId b) {
    if (graph.is_constant(b, 0)) return a;
    if (graph.is_constant(a, 0)) return graph.apply(Op::neg, b);
    if (is(graph, b, Op::neg)) return graph.apply(Op::add, a, argument(graph, b, 0));
    return id;
}

NodeId product(Graph& graph, NodeId id, NodeId a, NodeId b) {
    if (graph.is_constant(b, 1)) return a;
    if (graph.is_constant(a, 1)) return b;
    if (graph.is_constant(b, -1)) return graph.apply(Op::neg, a);
    if (graph.is_constant(a, -1)) return graph.apply(Op::neg, b);
    if (is(graph, a, Op::neg) && is(graph, b, Op::neg)) {
        return graph.apply(Op::mul, argument(graph, a, 0), argument(graph, b, 0));
    }
    if (a == b && is(graph, a, Op::abs)) {
        return graph.apply(Op::mul, argument(graph, a, 0), argument(graph, a, 0));
    }
    return id;
}

NodeId quotient(Graph& graph, NodeId id, NodeId a, NodeId b) {
    if (graph.is_constant(b, 1)) return a;
    if (graph.is_constant(b, -1)) return graph.apply(Op::neg, a);
    if (is(graph, a, Op::neg) && is(graph, b, Op::neg)) {
        return graph.apply(Op::div, argument(graph, a, 0), argument(graph, b, 0));
    }
    return id;
}

NodeId negation(Graph& graph, NodeId id, NodeId a) {
    if (is(graph, a, Op::neg)) return argument(graph, a, 0);
    if (is(graph, a, Op::sub)) {
        return graph.apply(Op::sub, argument(graph, a, 1), argument(graph, a, 0));
    }
    return id;
}

/// A function of the negated argument, or of what it has no effect on.
NodeId function(Graph& graph, NodeId id, Op op, NodeId a) {
    const auto listed = [op](const auto& list) { return std::ranges::count(list, op) > 0; };
    if (is(graph, a, Op::neg)) {
        const NodeId inner = argument(graph, a, 0);
        if (listed(even)) return graph.apply(op, inner);
        if (listed(odd)) return graph.apply(Op::neg, graph.apply(op, inner));
    }
    if ((op == Op::cos || op == Op::cosh) && is(graph, a, Op::abs)) {
        return graph.apply(op, argument(graph, a, 0));
    }
    if (op == Op::abs) {
        const bool square = is(graph, a, Op::mul) && argument(graph, a, 0) == argument(graph, a, 1);
        if (square || is_one_of(graph, a, not_negative)) return a;
    }
    if (listed(whole) && is_one_of(graph, a, whole) && (op != Op::sign || is(graph, a, Op::sign))) {
        return a;
    }
    return id;
}

/// Signs of what is squared.
NodeId length(Graph& graph, NodeId id) {
    Node node = graph[id];
    bool changed = false;
    for (std::size_t i = 0; i < node.args().size(); ++i) {
        const Node& side = graph[node.arguments[i]];
        if (side.op != Op::neg && side.op != Op::abs) continue;
        node.arguments[i] = side.arguments[0];
        changed = true;
    }
    return changed ? graph.apply(node.op, node.args()) : id;
}

}  // namespace

NodeId simplify(Graph& graph, NodeId id) {
    const Node node = graph[id];
    const NodeId a = node.arguments[0], b = node.arguments[1];
    if (node.op == Op::add) return sum(graph, id, a, b);
    if (node.op == Op::sub) return difference(graph, id, a, b);
    if (node.op == Op::mul) return product(graph, id, a, b);
    if (node.op == Op::div) return quotient(graph, id, a, b);
    if (node.op == Op::neg) return negation(graph, id, a);
    if (node.op == Op::hypot || node.op == Op::hypot3) return length(graph, id);
    if ((node.op == Op::min || node.op == Op::max) && a == b) return a;
    return node.args().size() == 1 ? function(graph, id, node.op, a) : id;
}

}  // namespace passes
