// SPDX-License-Identifier: MIT
#include "passes/expand_powers.h"

#include <cmath>

namespace passes {
namespace {

using graph::Graph;
using graph::NodeId;
using graph::Op;

constexpr int largest_exponent = 64;

NodeId whole_power(Graph& graph, NodeId base, int n) {
    if (n == 1) return base;
    const NodeId half = whole_power(graph, base, n / 2);
    const NodeId square = graph.apply(Op::mul, half, half);
    return n % 2 == 0 ? square : graph.apply(Op::mul, square, base);
}

}  // namespace

NodeId expand_powers(Graph& graph, NodeId id) {
    const graph::Node node = graph[id];
    if (node.op != Op::pow || !graph.is_constant(node.arguments[1])) return id;
    const NodeId base = node.arguments[0];
    const double exponent = graph[node.arguments[1]].value;
    const double size = std::abs(exponent);
    NodeId power;
    if (size == 0.5) {
        power = graph.apply(Op::sqrt, base);
    } else if (size >= 1 && size <= largest_exponent && size == std::floor(size)) {
        power = whole_power(graph, base, static_cast<int>(size));
    } else {
        // What is undefined stays so, also to the power of 0; leaves never are.
        return exponent == 0 && graph[base].args().empty() ? graph.constant(1) : id;
    }
    return exponent > 0 ? power : graph.apply(Op::div, graph.constant(1), power);
}

}  // namespace passes
