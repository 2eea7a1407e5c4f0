// SPDX-License-Identifier: MIT
#include "passes/rewrite.h"

#include <unordered_map>

#include "field/parts.h"

namespace passes {

using graph::NodeId;

std::vector<NodeId> rewrite(graph::Graph& graph, std::span<const NodeId> roots, Rule rule) {
    std::unordered_map<NodeId, NodeId> made;
    std::vector<NodeId> arguments;
    for (NodeId id : reachable(graph, roots)) {
        const graph::Node node = graph[id];
        NodeId rebuilt = id;
        if (!node.args().empty()) {
            arguments.clear();
            for (NodeId argument : node.args()) arguments.push_back(made.at(argument));
            rebuilt = graph.apply(node.op, arguments);
        }
        made[id] = rule(graph, rebuilt);
    }
    std::vector<NodeId> result;
    for (NodeId root : roots) result.push_back(made.at(root));
    return result;
}

void rewrite(field::Field& field, Rule rule) {
    std::vector<NodeId*> places;
    for (field::Node& node : field.nodes) {
        for (NodeId* place : expressions(node)) places.push_back(place);
    }
    std::vector<NodeId> roots;
    for (const NodeId* place : places) roots.push_back(*place);
    const std::vector<NodeId> rewritten = rewrite(field.graph, roots, rule);
    for (std::size_t i = 0; i < rewritten.size(); ++i) *places[i] = rewritten[i];
}

}  // namespace passes
