// SPDX-License-Identifier: MIT
#include "passes/simplify.h"

namespace passes {
namespace {

using graph::Graph;
using graph::Node;
using graph::NodeId;
using graph::Op;

NodeId argument(const Graph& graph, NodeId id, std::size_t i) { return graph[id].arguments[i]; }

NodeId sum(Graph& graph, NodeId id, NodeId a, NodeId b) {
    if (graph.is_constant(b, 0)) return a;
    if (graph.is_constant(a, 0)) return b;
    if (graph[b].op == Op::neg) return graph.apply(Op::sub, a, argument(graph, b, 0));
    if (graph[a].op == Op::neg) return graph.apply(Op::sub, b, argument(graph, a, 0));
    return id;
}

NodeId difference(Graph& graph, NodeId id, NodeId a, NodeId b) {
    if (graph.is_constant(b, 0)) return a;
    if (graph.is_constant(a, 0)) return graph.apply(Op::neg, b);
    if (graph[b].op == Op::neg) return graph.apply(Op::add, a, argument(graph, b, 0));
    return id;
}

NodeId product(Graph& graph, NodeId id, NodeId a, NodeId b) {
    if (graph.is_constant(b, 1)) return a;
    if (graph.is_constant(a, 1)) return b;
    if (graph.is_constant(b, -1)) return graph.apply(Op::neg, a);
    if (graph.is_constant(a, -1)) return graph.apply(Op::neg, b);
    if (graph[a].op == Op::neg && graph[b].op == Op::neg) {
        return graph.apply(Op::mul, argument(graph, a, 0), argument(graph, b, 0));
    }
    return id;
}

NodeId quotient(Graph& graph, NodeId id, NodeId a, NodeId b) {
    if (graph.is_constant(b, 1)) return a;
    if (graph.is_constant(b, -1)) return graph.apply(Op::neg, a);
    return id;
}

}  // namespace

NodeId simplify(Graph& graph, NodeId id) {
    const Node node = graph[id];
    const NodeId a = node.arguments[0], b = node.arguments[1];
    if (node.op == Op::add) return sum(graph, id, a, b);
    if (node.op == Op::sub) return difference(graph, id, a, b);
    if (node.op == Op::mul) return product(graph, id, a, b);
    if (node.op == Op::div) return quotient(graph, id, a, b);
    if (node.op == Op::neg && graph[a].op == Op::neg) return argument(graph, a, 0);
    if (node.op == Op::abs && (graph[a].op == Op::neg || graph[a].op == Op::abs)) {
        return graph.apply(Op::abs, argument(graph, a, 0));
    }
    if ((node.op == Op::min || node.op == Op::max) && a == b) return a;
    return id;
}

}  // namespace passes
