// SPDX-License-Identifier: MIT
#include "passes/order_operands.h"

namespace passes {

using graph::Graph;
using graph::Node;
using graph::NodeId;
using graph::Op;

namespace {

int class_of(Op op) {
    if (op == Op::constant) return 0;
    if (op == Op::parameter) return 1;
    return op == Op::variable ? 2 : 3;
}

}  // namespace

bool stands_before(const Graph& graph, NodeId a, NodeId b) {
    const Node& left = graph[a];
    const Node& right = graph[b];
    const int left_class = class_of(left.op), right_class = class_of(right.op);
    if (left_class != right_class) return left_class < right_class;
    // The sign of a zero and NaN have no order by size.
    if (left.op == Op::constant && left.value < right.value) return true;
    if (left.op == Op::constant && left.value > right.value) return false;
    if (left.symbol != right.symbol) return left.symbol < right.symbol;
    return a < b;
}

NodeId order_operands(Graph& graph, NodeId id) {
    const Node& node = graph[id];
    if (node.op != Op::add && node.op != Op::mul && node.op != Op::hypot) return id;
    const auto [a, b, c, d] = node.arguments;
    return stands_before(graph, b, a) ? graph.apply(node.op, b, a) : id;
}

}  // namespace passes
