// SPDX-License-Identifier: MIT
#include "passes/rewrite.h"

#include <unordered_map>
#include <variant>

namespace passes {
namespace {

using graph::NodeId;

/// Pointers to all expressions that a field's nodes hold.
struct Expressions {
    std::vector<NodeId*> list;

    void add(std::optional<field::Colour>& colour) {
        if (!colour) return;
        for (NodeId& id : *colour) list.push_back(&id);
    }
    void operator()(field::Formula& leaf) {
        list.push_back(&leaf.value);
        add(leaf.colour);
    }
    void operator()(field::Iteration& leaf) {
        for (NodeId& id : leaf.start) list.push_back(&id);
        for (NodeId& id : leaf.step) list.push_back(&id);
        list.push_back(&leaf.limit);
        if (leaf.escape) list.push_back(&*leaf.escape);
        list.push_back(&leaf.distance);
        add(leaf.colour);
    }
    void operator()(field::SmoothUnion& node) { list.push_back(&node.k); }
    void operator()(field::Union&) {}
    void operator()(field::Intersection&) {}
    void operator()(field::Complement&) {}
};

}  // namespace

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
    Expressions expressions;
    for (field::Node& node : field.nodes) std::visit(expressions, node);
    std::vector<NodeId> roots;
    for (NodeId* place : expressions.list) roots.push_back(*place);
    const std::vector<NodeId> rewritten = rewrite(field.graph, roots, rule);
    for (std::size_t i = 0; i < rewritten.size(); ++i) *expressions.list[i] = rewritten[i];
}

}  // namespace passes
