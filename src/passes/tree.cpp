// SPDX-License-Identifier: MIT
#include "passes/tree.h"

#include <algorithm>

namespace passes {

using graph::Graph;
using graph::NodeId;

Usage usage(const Graph& graph, std::span<const NodeId> roots) {
    Usage result{reachable(graph, roots), std::vector<std::uint32_t>(graph.size(), 0)};
    for (const NodeId root : roots) ++result.count[index(root)];
    for (const NodeId id : result.order) {
        for (const NodeId argument : graph[id].args()) ++result.count[index(argument)];
    }
    return result;
}

std::vector<bool> inner_nodes(const Graph& graph, const Usage& usage,
                              std::span<const graph::Op> operators) {
    const auto listed = [&](NodeId id) { return std::ranges::count(operators, graph[id].op) > 0; };
    std::vector<bool> inner(graph.size(), false);
    for (const NodeId id : usage.order) {
        if (!listed(id)) continue;
        for (const NodeId argument : graph[id].args()) {
            inner[index(argument)] = listed(argument) && usage.count[index(argument)] == 1;
        }
    }
    return inner;
}

}  // namespace passes
