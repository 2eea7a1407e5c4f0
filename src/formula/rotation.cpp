// SPDX-License-Identifier: MIT
#include "formula/rotation.h"

#include <cmath>
#include <numbers>

#include "formula/trimmed_arithmetic.h"

namespace formula {
namespace {

using graph::Graph;
using graph::NodeId;
using graph::Op;

/// A number that is an expression of constants but not folded counts as an expression here.
bool is_constant(const Graph& graph, const Direction& vector) {
    return graph.is_constant(vector[0]) && graph.is_constant(vector[1]) &&
           graph.is_constant(vector[2]);
}

struct Angle {
    NodeId cosine{}, sine{};
};

/// Exact for multiples of 90 degrees.
Angle angle(Graph& graph, NodeId degrees) {
    if (graph.is_constant(degrees)) {
        const double quarters = std::remainder(graph[degrees].value, 360.0) / 90.0;
        const int whole = static_cast<int>(std::nearbyint(quarters));
        const double rest = (quarters - whole) * std::numbers::pi / 2;
        const double c = std::cos(rest), s = std::sin(rest);
        switch ((whole + 4) % 4) {
            case 0:
                return {graph.constant(c), graph.constant(s)};
            case 1:
                return {graph.constant(-s), graph.constant(c)};
            case 2:
                return {graph.constant(-c), graph.constant(-s)};
            case 3:
                return {graph.constant(s), graph.constant(-c)};
        }
    }
    const NodeId radians = graph.apply(Op::mul, degrees, graph.constant(std::numbers::pi / 180.0));
    return {graph.apply(Op::cos, radians), graph.apply(Op::sin, radians)};
}

}  // namespace

Direction unit(Graph& graph, const Direction& axis) {
    Direction result{};
    if (is_constant(graph, axis)) {
        const double length =
            std::hypot(graph[axis[0]].value, graph[axis[1]].value, graph[axis[2]].value);
        for (int i = 0; i < 3; ++i) result[i] = graph.constant(graph[axis[i]].value / length);
        return result;
    }
    const NodeId length = graph.apply(Op::hypot3, axis[0], axis[1], axis[2]);
    for (int i = 0; i < 3; ++i) result[i] = graph.apply(Op::div, axis[i], length);
    return result;
}

std::array<NodeId, 3> turned(Graph& graph, const std::array<NodeId, 3>& point,
                             const Direction& axis, NodeId degrees, Sense sense) {
    const TrimmedArithmetic calculate{graph};
    const Direction n = unit(graph, axis);
    const auto [cosine, sine] = angle(graph, degrees);
    const NodeId versine = calculate.sub(graph.constant(1), cosine);
    std::array<NodeId, 3> result{};
    // Rodrigues' matrix n n^T + c (1 - n n^T) + s [n]x; of the inverse - s [n]x.
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const NodeId square = calculate.mul(n[i], n[i]);
        const NodeId diagonal =
            calculate.add(square, calculate.mul(cosine, calculate.sub(graph.constant(1), square)));
        const NodeId even_j = calculate.mul(calculate.mul(n[i], n[j]), versine);
        const NodeId even_k = calculate.mul(calculate.mul(n[i], n[k]), versine);
        const NodeId odd_j = calculate.mul(n[k], sine), odd_k = calculate.mul(n[j], sine);
        const bool inverse = sense == Sense::inverse;
        const NodeId to_j = inverse ? calculate.add(even_j, odd_j) : calculate.sub(even_j, odd_j);
        const NodeId to_k = inverse ? calculate.sub(even_k, odd_k) : calculate.add(even_k, odd_k);
        result[i] = calculate.add(
            calculate.mul(diagonal, point[i]),
            calculate.add(calculate.mul(to_j, point[j]), calculate.mul(to_k, point[k])));
    }
    return result;
}

}  // namespace formula
