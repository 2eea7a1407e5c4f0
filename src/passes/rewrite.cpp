// SPDX-License-Identifier: MIT
#include "passes/rewrite.h"

#include "field/parts.h"

namespace passes {

using graph::NodeId;

std::vector<NodeId> rewrite(graph::Graph& graph, std::span<const NodeId> roots,
                            const std::function<NodeId(graph::Graph&, NodeId)>& rule) {
    std::vector<NodeId> made(graph.size());
    for (NodeId id : reachable(graph, roots)) {
        graph::Node node = graph[id];
        NodeId rebuilt = id;
        if (!node.args().empty()) {
            for (NodeId& argument : node.arguments) argument = made[index(argument)];
            rebuilt = graph.apply(node.op, node.args());
        }
        made[index(id)] = rule(graph, rebuilt);
    }
    std::vector<NodeId> result;
    for (NodeId root : roots) result.push_back(made[index(root)]);
    return result;
}

std::vector<NodeId*> all_expressions(field::Field& field) {
    std::vector<NodeId*> places;
    for (field::Node& node : field.nodes) {
        for (NodeId* place : expressions(node)) places.push_back(place);
    }
    return places;
}

}  // namespace passes
