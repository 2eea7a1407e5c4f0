// SPDX-License-Identifier: MIT
#include "analysis/polynomial_degree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace analysis {
namespace {

using graph::NodeId;
using graph::Op;
using Degree = std::optional<int>;

Degree limited(double degree) {
    if (degree > largest_degree) return std::nullopt;
    return static_cast<int>(degree);
}

/// The whole number that the node is, if it is one and not negative.
std::optional<double> whole_exponent(const graph::Graph& graph, NodeId id) {
    if (!graph.is_constant(id)) return std::nullopt;
    const double value = graph[id].value;
    if (value < 0 || value > largest_degree || value != std::floor(value)) return std::nullopt;
    return value;
}

struct Degrees {
    const graph::Graph& graph;
    std::span<const graph::VariableId> variables;
    std::vector<Degree> of{};

    Degree argument(const graph::Node& node, std::size_t i) const {
        return of[index(node.args()[i])];
    }

    Degree find(const graph::Node& node) const {
        if (node.op == Op::variable) {
            const auto id = static_cast<graph::VariableId>(node.symbol);
            return std::ranges::find(variables, id) == variables.end() ? 0 : 1;
        }
        const bool coefficient =
            std::ranges::all_of(node.args(), [&](NodeId id) { return of[index(id)] == 0; });
        if (coefficient) return 0;
        if (node.op == Op::neg) return argument(node, 0);
        if (node.op == Op::div && argument(node, 1) == 0) return argument(node, 0);
        if (node.args().size() != 2) return std::nullopt;
        const Degree a = argument(node, 0), b = argument(node, 1);
        if (!a || !b) return std::nullopt;
        if (node.op == Op::add || node.op == Op::sub) return std::max(*a, *b);
        if (node.op == Op::mul) return limited(static_cast<double>(*a) + *b);
        const auto exponent = whole_exponent(graph, node.args()[1]);
        if (node.op == Op::pow && exponent) return limited(*a * *exponent);
        return std::nullopt;
    }
};

}  // namespace

std::optional<int> polynomial_degree(const graph::Graph& graph, std::span<const NodeId> roots,
                                     std::span<const graph::VariableId> variables) {
    Degrees degrees{graph, variables, std::vector<Degree>(graph.size())};
    for (const NodeId id : reachable(graph, roots)) {
        degrees.of[index(id)] = degrees.find(graph[id]);
    }
    int largest = 0;
    for (const NodeId root : roots) {
        const Degree degree = degrees.of[index(root)];
        if (!degree) return std::nullopt;
        largest = std::max(largest, *degree);
    }
    return largest;
}

std::optional<int> polynomial_degree(const graph::Graph& graph, NodeId root) {
    constexpr std::array point{graph::variable_x, graph::variable_y, graph::variable_z};
    return polynomial_degree(graph, std::array{root}, point);
}

}  // namespace analysis
