// SPDX-License-Identifier: MIT
#include "passes/power_of.h"

#include <cmath>

#include "passes/addition_chain.h"

namespace passes {

using graph::NodeId;
using graph::Op;

int whole_exponent(const graph::Graph& graph, NodeId id) {
    if (!graph.is_constant(id)) return 0;
    const double value = graph[id].value;
    const bool fits = value >= 1 && value <= largest_chained_exponent && value == std::floor(value);
    return fits ? static_cast<int>(value) : 0;
}

PowerOf Powers::of(const graph::Node& node, NodeId id) const {
    if (node.op == Op::mul) {
        const PowerOf a = known_[index(node.arguments[0])], b = known_[index(node.arguments[1])];
        const int sum = a.exponent + b.exponent;
        if (a.base == b.base && sum <= largest_chained_exponent) return {a.base, sum};
    }
    if (node.op == Op::pow) {
        const PowerOf base = known_[index(node.arguments[0])];
        const int n = whole_exponent(graph_, node.arguments[1]);
        if (n == 0) return {id, 1};
        if (n * base.exponent <= largest_chained_exponent) {
            return {base.base, n * base.exponent};
        }
        return {node.arguments[0], n};
    }
    return {id, 1};
}

PowerOf Powers::operator[](NodeId id) {
    for (std::size_t i = known_.size(); i <= index(id); ++i) {
        const auto next = static_cast<NodeId>(i);
        known_.push_back(of(graph_[next], next));
    }
    return known_[index(id)];
}

}  // namespace passes
