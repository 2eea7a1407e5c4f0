// SPDX-License-Identifier: MIT
#include "formula/domain_maps.h"

#include "field/map_domain.h"
#include "formula/rotation.h"
#include "formula/trimmed_arithmetic.h"

namespace formula {
namespace {

using graph::Graph;
using graph::NodeId;

Vector point(Graph& graph) {
    return {graph.variable(graph::variable_x), graph.variable(graph::variable_y),
            graph.variable(graph::variable_z)};
}

}  // namespace

field::FieldId translate(field::Field& field, field::FieldId id, const Vector& offset) {
    const TrimmedArithmetic calculate{field.graph};
    Vector moved = point(field.graph);
    for (int i = 0; i < 3; ++i) moved[i] = calculate.sub(moved[i], offset[i]);
    return field::map_domain(field, id, moved, field.graph.constant(1));
}

field::FieldId rotate(field::Field& field, field::FieldId id, const Vector& axis,
                      graph::NodeId degrees) {
    const Vector back = turned(field.graph, point(field.graph), axis, degrees, Sense::inverse);
    return field::map_domain(field, id, back, field.graph.constant(1));
}

field::FieldId scale(field::Field& field, field::FieldId id, graph::NodeId factor) {
    Vector shrunk = point(field.graph);
    for (NodeId& it : shrunk) it = field.graph.apply(graph::Op::div, it, factor);
    return field::map_domain(field, id, shrunk, factor);
}

field::FieldId scale(field::Field& field, field::FieldId id, const Vector& factors) {
    graph::Graph& graph = field.graph;
    Vector shrunk = point(graph);
    for (int i = 0; i < 3; ++i) shrunk[i] = graph.apply(graph::Op::div, shrunk[i], factors[i]);
    // Cells need a map that keeps angles.
    if (field::has_cells(field, id)) return field::distort_domain(field, id, shrunk);
    NodeId least = graph.apply(graph::Op::min, factors[0], factors[1]);
    least = graph.apply(graph::Op::min, least, factors[2]);
    return field::bound_domain(field, id, shrunk, least);
}

field::FieldId bend(field::Field& field, field::FieldId id, NodeId curvature) {
    graph::Graph& graph = field.graph;
    const NodeId half = graph.apply(graph::Op::mul, curvature, graph.constant(0.5));
    const NodeId x = graph.variable(graph::variable_x);
    return field::turn_domain(field, id, graph.apply(graph::Op::mul, half, x));
}

}  // namespace formula
