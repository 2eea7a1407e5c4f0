// SPDX-License-Identifier: MIT
#include "passes/recognise_hypot.h"

#include <vector>

namespace passes {
namespace {

using graph::Graph;
using graph::NodeId;
using graph::Op;

/// Collects the roots of the squares that a sum consists of; false if a part is no square, or if
/// there are more than three.
bool collect_squares(const Graph& graph, NodeId id, std::vector<NodeId>& roots) {
    const graph::Node& node = graph[id];
    if (node.op == Op::mul && node.arguments[0] == node.arguments[1]) {
        roots.push_back(node.arguments[0]);
        return roots.size() <= 3;
    }
    return node.op == Op::add && collect_squares(graph, node.arguments[0], roots) &&
           collect_squares(graph, node.arguments[1], roots);
}

}  // namespace

NodeId recognise_hypot(Graph& graph, NodeId id) {
    if (graph[id].op != Op::sqrt) return id;
    std::vector<NodeId> roots;
    if (!collect_squares(graph, graph[id].arguments[0], roots)) return id;
    if (roots.size() == 1) return graph.apply(Op::abs, roots);
    return graph.apply(roots.size() == 2 ? Op::hypot : Op::hypot3, roots);
}

}  // namespace passes
