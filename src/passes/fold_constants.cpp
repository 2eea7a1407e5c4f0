// SPDX-License-Identifier: MIT
#include "passes/fold_constants.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "eval/operators.h"

namespace passes {

graph::NodeId fold_constants(graph::Graph& graph, graph::NodeId id) {
    const graph::Node& node = graph[id];
    const auto arguments = node.args();
    if (arguments.empty()) return id;
    std::array<double, graph::max_arity> values{};
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (!graph.is_constant(arguments[i])) return id;
        values[i] = graph[arguments[i]].value;
    }
    const double value = eval::apply<double>(node.op, values);
    return std::isfinite(value) ? graph.constant(value) : id;
}

}  // namespace passes
