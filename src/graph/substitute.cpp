// SPDX-License-Identifier: MIT
#include "graph/substitute.h"

#include <unordered_map>

namespace graph {
namespace {

NodeId replaced(Graph& graph, NodeId id, const std::unordered_map<NodeId, NodeId>& made,
                std::span<const std::pair<VariableId, NodeId>> replacements) {
    const Node node = graph[id];
    if (node.op == Op::variable) {
        for (const auto& [variable, by] : replacements) {
            if (node.symbol == index(variable)) return by;
        }
    }
    if (node.args().empty()) return id;
    std::vector<NodeId> arguments;
    for (NodeId argument : node.args()) arguments.push_back(made.at(argument));
    return graph.apply(node.op, arguments);
}

}  // namespace

std::vector<NodeId> substitute(Graph& graph, std::span<const NodeId> roots,
                               std::span<const std::pair<VariableId, NodeId>> replacements) {
    std::unordered_map<NodeId, NodeId> made;
    for (NodeId id : reachable(graph, roots)) made[id] = replaced(graph, id, made, replacements);
    std::vector<NodeId> result;
    for (NodeId root : roots) result.push_back(made.at(root));
    return result;
}

}  // namespace graph
