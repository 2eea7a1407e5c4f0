// SPDX-License-Identifier: MIT
#include "passes/depends_on.h"

#include <algorithm>
#include <array>

namespace passes {

bool depends_on(const graph::Graph& graph, graph::NodeId root,
                std::span<const graph::VariableId> variables) {
    return std::ranges::any_of(reachable(graph, std::array{root}), [&](graph::NodeId id) {
        const graph::Node& node = graph[id];
        return node.op == graph::Op::variable &&
               std::ranges::find(variables, static_cast<graph::VariableId>(node.symbol)) !=
                   variables.end();
    });
}

}  // namespace passes
