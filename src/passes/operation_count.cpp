// SPDX-License-Identifier: MIT
#include "passes/operation_count.h"

#include <cmath>

#include "passes/addition_chain.h"
#include "passes/rate.h"

namespace passes {
namespace {

std::size_t multiplied_out(const graph::Graph& graph, const graph::Node& node) {
    if (node.op != graph::Op::pow || !graph.is_constant(node.arguments[1])) return 1;
    const double exponent = graph[node.arguments[1]].value;
    const double size = std::abs(exponent);
    const bool division = exponent < 0;
    if (!(size >= 1 && size <= largest_chained_exponent && size == std::floor(size))) {
        return 1 + (division ? 1 : 0);
    }
    return addition_chain(static_cast<int>(size)).size() + (division ? 1 : 0);
}

}  // namespace

OperationCount count_operations(const graph::Graph& graph, std::span<const graph::NodeId> roots) {
    OperationCount count;
    Rates rates(graph);
    for (const graph::NodeId id : reachable(graph, roots)) {
        const graph::Node& node = graph[id];
        if (node.args().empty()) continue;
        if (rates[id] < Rate::point) {
            ++count.hoisted;
            continue;
        }
        ++count.by_operator[static_cast<std::size_t>(node.op)];
        ++count.at_points;
        count.multiplied_out += multiplied_out(graph, node);
    }
    return count;
}

}  // namespace passes
