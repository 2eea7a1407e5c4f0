// SPDX-License-Identifier: MIT
#include "passes/spell_out_lengths.h"

#include <optional>

#include "graph/build.h"

namespace passes {
namespace {

using graph::Expr;
using graph::Graph;
using graph::Node;
using graph::NodeId;
using graph::Op;

/// Smallest square that is divided by; the squares of smaller lengths are denormal in single
/// precision.
constexpr double least_square = 1e-36;

Expr square(Graph& graph, NodeId id) { return Expr(graph, id) * Expr(graph, id); }

/// size * above / below, 0 for 0 / 0.
struct Ratio {
    double size = 1;
    NodeId above{}, below{};
};

/// The node as a multiple of a ratio.
std::optional<Ratio> ratio_in(const Graph& graph, NodeId id) {
    const Node& node = graph[id];
    if (node.op == Op::ratio) return Ratio{1, node.arguments[0], node.arguments[1]};
    if (node.op != Op::mul) return std::nullopt;
    for (const int k : {0, 1}) {
        const NodeId number = node.arguments[static_cast<std::size_t>(k)];
        if (!graph.is_constant(number)) continue;
        auto ratio = ratio_in(graph, node.arguments[static_cast<std::size_t>(1 - k)]);
        if (ratio) ratio->size *= graph[number].value;
        return ratio;
    }
    return std::nullopt;
}

NodeId product(Graph& graph, NodeId id) {
    const auto [a, b, c, d] = graph[id].arguments;
    const NodeId under = graph[a].arguments[0];
    if (a == b && graph[a].op == Op::sqrt && is_sum_of_squares(graph, under)) return under;
    const auto left = ratio_in(graph, a), right = ratio_in(graph, b);
    if (!left || !right || left->below != right->below) return id;
    const Node length = graph[left->below];
    if (length.op != Op::sqrt || !is_sum_of_squares(graph, length.arguments[0])) return id;
    const Expr reciprocal = 1.0 / max(Expr(graph, length.arguments[0]), least_square);
    const Expr above = Expr(graph, left->above) * Expr(graph, right->above);
    const double size = left->size * right->size;
    return (size == 1 ? above * reciprocal : size * above * reciprocal).id;
}

}  // namespace

bool is_sum_of_squares(const Graph& graph, NodeId id) {
    const Node& node = graph[id];
    if (node.op == Op::mul) return node.arguments[0] == node.arguments[1];
    return node.op == Op::add && is_sum_of_squares(graph, node.arguments[0]) &&
           is_sum_of_squares(graph, node.arguments[1]);
}

NodeId spell_out_lengths(Graph& graph, NodeId id) {
    const Node node = graph[id];
    const auto [a, b, c, d] = node.arguments;
    if (node.op == Op::hypot) return sqrt(square(graph, a) + square(graph, b)).id;
    if (node.op == Op::hypot3) {
        return sqrt(square(graph, a) + square(graph, b) + square(graph, c)).id;
    }
    return node.op == Op::mul ? product(graph, id) : id;
}

}  // namespace passes
