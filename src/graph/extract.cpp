// SPDX-License-Identifier: MIT
#include "graph/extract.h"

#include <algorithm>

namespace graph {
namespace {

void add_names(const Graph& from, Graph& to) {
    for (std::size_t i = to.variable_count(); i < from.variable_count(); ++i) {
        to.new_variable(from.name(static_cast<VariableId>(i)));
    }
    for (std::size_t i = to.parameter_count(); i < from.parameter_count(); ++i) {
        to.new_parameter(from.name(static_cast<ParameterId>(i)));
    }
}

NodeId copy(const Node& node, Graph& to, const std::vector<NodeId>& order,
            const std::vector<NodeId>& made) {
    if (node.op == Op::constant) return to.constant(node.value);
    if (node.op == Op::variable) return to.variable(static_cast<VariableId>(node.symbol));
    if (node.op == Op::parameter) return to.parameter(static_cast<ParameterId>(node.symbol));
    std::array<NodeId, max_arity> arguments{};
    for (std::size_t i = 0; i < node.args().size(); ++i) {
        const auto place = std::ranges::lower_bound(order, node.args()[i]);
        arguments[i] = made[static_cast<std::size_t>(place - order.begin())];
    }
    return to.apply(node.op, std::span(arguments).first(node.args().size()));
}

}  // namespace

Extract extract(const Graph& graph, std::span<const NodeId> roots) {
    Extract part;
    add_names(graph, part.graph);
    const std::vector<NodeId> order = reachable(graph, roots);
    std::vector<NodeId> made;
    made.reserve(order.size());
    for (const NodeId id : order) made.push_back(copy(graph[id], part.graph, order, made));
    for (const NodeId root : roots) {
        const auto place = std::ranges::lower_bound(order, root);
        part.roots.push_back(made[static_cast<std::size_t>(place - order.begin())]);
    }
    return part;
}

}  // namespace graph
