// SPDX-License-Identifier: MIT
#include "formula/domain_maps.h"

#include <cmath>
#include <numbers>

namespace formula {
namespace {

using graph::Graph;
using graph::NodeId;
using graph::Op;

/// Arithmetic that leaves out what constants make trivial, so that a turn about a coordinate axis
/// touches only the two other coordinates.
struct Arithmetic {
    Graph& graph;

    bool both_constant(NodeId a, NodeId b) const {
        return graph.is_constant(a) && graph.is_constant(b);
    }
    double value(NodeId id) const { return graph[id].value; }
    NodeId constant(double value) const { return graph.constant(value); }

    NodeId add(NodeId a, NodeId b) const {
        if (both_constant(a, b)) return constant(value(a) + value(b));
        if (graph.is_constant(a, 0)) return b;
        if (graph.is_constant(b, 0)) return a;
        return graph.apply(Op::add, a, b);
    }
    NodeId sub(NodeId a, NodeId b) const {
        if (both_constant(a, b)) return constant(value(a) - value(b));
        if (graph.is_constant(b, 0)) return a;
        return graph.apply(Op::sub, a, b);
    }
    NodeId mul(NodeId a, NodeId b) const {
        if (both_constant(a, b)) return constant(value(a) * value(b));
        if (graph.is_constant(a, 0) || graph.is_constant(b, 0)) return constant(0);
        if (graph.is_constant(a, 1)) return b;
        if (graph.is_constant(b, 1)) return a;
        return graph.apply(Op::mul, a, b);
    }
};

Vector point(Graph& graph) {
    return {graph.variable(graph::variable_x), graph.variable(graph::variable_y),
            graph.variable(graph::variable_z)};
}

/// A number that is an expression of constants but not folded counts as an expression here.
bool is_constant(const Graph& graph, const Vector& vector) {
    return graph.is_constant(vector[0]) && graph.is_constant(vector[1]) &&
           graph.is_constant(vector[2]);
}

Vector unit(Graph& graph, const Vector& axis) {
    Vector result{};
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

struct Turn {
    NodeId cosine{}, sine{};
};

/// Exact for multiples of 90 degrees.
Turn turn(Graph& graph, NodeId degrees) {
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

field::FieldId translate(field::Field& field, field::FieldId id, const Vector& offset) {
    const Arithmetic calculate{field.graph};
    Vector moved = point(field.graph);
    for (int i = 0; i < 3; ++i) moved[i] = calculate.sub(moved[i], offset[i]);
    return field::map_domain(field, id, moved, field.graph.constant(1));
}

field::FieldId rotate(field::Field& field, field::FieldId id, const Vector& axis,
                      graph::NodeId degrees) {
    const Arithmetic calculate{field.graph};
    const Vector n = unit(field.graph, axis);
    const auto [cosine, sine] = turn(field.graph, degrees);
    const NodeId one = field.graph.constant(1);
    const Vector p = point(field.graph);
    Vector turned{};
    // The inverse of Rodrigues' matrix: n n^T + c (1 - n n^T) - s [n]x.
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const NodeId square = calculate.mul(n[i], n[i]);
        const NodeId diagonal =
            calculate.add(square, calculate.mul(cosine, calculate.sub(one, square)));
        const NodeId versine = calculate.sub(one, cosine);
        const NodeId to_j = calculate.add(calculate.mul(calculate.mul(n[i], n[j]), versine),
                                          calculate.mul(n[k], sine));
        const NodeId to_k = calculate.sub(calculate.mul(calculate.mul(n[i], n[k]), versine),
                                          calculate.mul(n[j], sine));
        turned[i] =
            calculate.add(calculate.mul(diagonal, p[i]),
                          calculate.add(calculate.mul(to_j, p[j]), calculate.mul(to_k, p[k])));
    }
    return field::map_domain(field, id, turned, one);
}

field::FieldId scale(field::Field& field, field::FieldId id, graph::NodeId factor) {
    Vector shrunk = point(field.graph);
    for (NodeId& it : shrunk) it = field.graph.apply(Op::div, it, factor);
    return field::map_domain(field, id, shrunk, factor);
}

}  // namespace formula
