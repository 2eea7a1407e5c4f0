// SPDX-License-Identifier: MIT
#include "graph/print.h"

#include <array>
#include <charconv>
#include <unordered_map>
#include <utility>

namespace graph {

std::string shortest(double value) {
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

std::string print(const Graph& graph, std::span<const NodeId> roots,
                  std::vector<std::string>* names) {
    std::unordered_map<NodeId, std::string> name;
    std::string text;
    for (NodeId id : reachable(graph, roots)) {
        const Node& node = graph[id];
        std::string right;
        if (node.op == Op::constant) {
            right = shortest(node.value);
        } else if (node.op == Op::variable) {
            right = graph.name(static_cast<VariableId>(node.symbol));
        } else if (node.op == Op::parameter) {
            right = "parameter " + graph.name(static_cast<ParameterId>(node.symbol));
        } else {
            right = facts(node.op).name;
            for (NodeId argument : node.args()) right.append(" ").append(name.at(argument));
        }
        std::string fresh(1, 'n');
        fresh += std::to_string(name.size());
        text.append(fresh).append(" = ").append(right).append("\n");
        name.emplace(id, std::move(fresh));
    }
    if (names) {
        names->clear();
        for (NodeId root : roots) names->push_back(name.at(root));
    }
    return text;
}

}  // namespace graph
