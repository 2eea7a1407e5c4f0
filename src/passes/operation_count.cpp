// SPDX-License-Identifier: MIT
#include "passes/operation_count.h"

#include <cmath>

#include "passes/addition_chain.h"
#include "passes/rate.h"

namespace passes {
namespace {

/// A power that is not multiplied out; more than any chain, so that an exponent that is folded to a
/// whole number is never a loss.
constexpr std::size_t by_logarithm = 16;

std::size_t multiplied_out(const graph::Graph& graph, const graph::Node& node) {
    if (node.op != graph::Op::pow) return 1;
    if (!graph.is_constant(node.arguments[1])) return by_logarithm;
    const double exponent = graph[node.arguments[1]].value;
    const double size = std::abs(exponent);
    if (!(size >= 1 && size <= largest_chained_exponent && size == std::floor(size))) {
        return by_logarithm;
    }
    return addition_chain(static_cast<int>(size)).size() + (exponent < 0 ? 1 : 0);
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
