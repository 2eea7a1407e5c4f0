// SPDX-License-Identifier: MIT
#include "formula/orbit.h"

#include <algorithm>
#include <cmath>

#include "formula/trimmed_arithmetic.h"
#include "formula/vector.h"

namespace formula {
namespace {

using graph::Expr;
using graph::Graph;
using graph::NodeId;
using graph::Op;

bool is_uniform(Lowering& lowering, const std::vector<NodeId>& nodes) {
    return std::ranges::none_of(nodes, [&](NodeId id) {
        return lowering.facts.depends_on_point(lowering.field.graph, id);
    });
}

/// True if each component is x, y or z, none of them twice, or the same everywhere.
bool is_placed_point(Lowering& lowering, const std::vector<NodeId>& nodes) {
    const Graph& graph = lowering.field.graph;
    bool seen[3] = {};
    for (const NodeId id : nodes) {
        if (!lowering.facts.depends_on_point(graph, id)) continue;
        const graph::Node& node = graph[id];
        if (node.op != Op::variable || node.symbol > 2 || seen[node.symbol]) return false;
        seen[node.symbol] = true;
    }
    return true;
}

NodeId length_of(Lowering& lowering, const VectorValue& vector) {
    return length(components(lowering.field.graph, vector.components)).id;
}

/// |number| if it is the same at every point and turn.
std::optional<NodeId> uniform_size(Lowering& lowering, NodeId number) {
    Graph& graph = lowering.field.graph;
    if (lowering.facts.depends_on_point(graph, number)) return std::nullopt;
    const std::optional<double> known = lowering.facts.constant(graph, number);
    return known ? graph.constant(std::abs(*known)) : graph.apply(Op::abs, number);
}

/// What is not left out of the stretch, if anything is.
NodeId full_stretch(const Orbit& orbit) { return orbit.across.value_or(orbit.stretch); }

}  // namespace

std::optional<Orbit> orbit_of(Lowering& lowering, const VectorValue& vector) {
    if (vector.orbit) return vector.orbit;
    Graph& graph = lowering.field.graph;
    const bool uniform = is_uniform(lowering, vector.components);
    if (!uniform && !is_placed_point(lowering, vector.components)) return std::nullopt;
    return Orbit{graph.constant(uniform ? 0 : 1), graph.constant(0), length_of(lowering, vector)};
}

std::optional<Orbit> orbit_of_sum(Lowering& lowering, const VectorValue& a, const VectorValue& b) {
    if (!a.orbit && !b.orbit) return std::nullopt;
    Graph& graph = lowering.field.graph;
    const TrimmedArithmetic calculate{graph};
    const std::optional<Orbit> left = orbit_of(lowering, a), right = orbit_of(lowering, b);
    if (!left || !right) return std::nullopt;
    const NodeId stretch = calculate.add(left->stretch, right->stretch);
    std::optional<NodeId> across;
    if (left->across || right->across) {
        across = calculate.add(full_stretch(*left), full_stretch(*right));
    }
    if (left->degree == right->degree) {
        return Orbit{stretch, left->degree, calculate.add(left->scale, right->scale), across};
    }
    const bool both_known = graph.is_constant(left->degree) && graph.is_constant(right->degree);
    if (graph.is_constant(left->degree, 0) ||
        (both_known && graph[left->degree].value < graph[right->degree].value)) {
        return Orbit{stretch, right->degree, right->scale, across};
    }
    if (graph.is_constant(right->degree, 0) || both_known) {
        return Orbit{stretch, left->degree, left->scale, across};
    }
    return std::nullopt;
}

std::optional<Orbit> orbit_of_multiple(Lowering& lowering, NodeId number, const VectorValue& v) {
    if (!v.orbit) return std::nullopt;
    const std::optional<NodeId> size = uniform_size(lowering, number);
    if (!size) return std::nullopt;
    Graph& graph = lowering.field.graph;
    const TrimmedArithmetic calculate{graph};
    std::optional<NodeId> across;
    if (v.orbit->across) across = calculate.mul(*size, *v.orbit->across);
    return Orbit{calculate.mul(*size, v.orbit->stretch), v.orbit->degree,
                 calculate.mul(*size, v.orbit->scale), across};
}

std::optional<Orbit> orbit_of_fraction(Lowering& lowering, const VectorValue& v, NodeId number) {
    if (!v.orbit) return std::nullopt;
    const std::optional<NodeId> size = uniform_size(lowering, number);
    if (!size) return std::nullopt;
    Graph& graph = lowering.field.graph;
    std::optional<NodeId> across;
    if (v.orbit->across) across = graph.apply(Op::div, *v.orbit->across, *size);
    return Orbit{graph.apply(Op::div, v.orbit->stretch, *size), v.orbit->degree,
                 graph.apply(Op::div, v.orbit->scale, *size), across};
}

std::optional<Orbit> orbit_of_product(Lowering& lowering, const VectorValue& a,
                                      const VectorValue& b) {
    if (!a.orbit && !b.orbit) return std::nullopt;
    const std::optional<Orbit> left = orbit_of(lowering, a), right = orbit_of(lowering, b);
    if (!left || !right) return std::nullopt;
    Graph& graph = lowering.field.graph;
    const TrimmedArithmetic calculate{graph};
    const NodeId by_right = graph.is_constant(right->stretch, 0)
                                ? right->stretch
                                : calculate.mul(length_of(lowering, a), right->stretch);
    const NodeId by_left = graph.is_constant(left->stretch, 0)
                               ? left->stretch
                               : calculate.mul(length_of(lowering, b), left->stretch);
    return Orbit{calculate.add(by_right, by_left), calculate.add(left->degree, right->degree),
                 calculate.mul(left->scale, right->scale)};
}

std::optional<Orbit> orbit_of_power(Lowering& lowering, const VectorValue& v, NodeId n) {
    if (!v.orbit || lowering.facts.depends_on_point(lowering.field.graph, n)) return std::nullopt;
    Graph& graph = lowering.field.graph;
    const TrimmedArithmetic calculate{graph};
    const std::optional<double> known = lowering.facts.constant(graph, n);
    if (known && !(*known > 0)) return std::nullopt;
    const Expr power = known ? Expr(graph, *known) : Expr(graph, n);
    const Expr size(graph, length_of(lowering, v));
    const Expr rest = known == 2 ? size : pow(size, power - 1.0);
    return Orbit{(power * rest * Expr(graph, v.orbit->stretch)).id,
                 calculate.mul(power.id, v.orbit->degree),
                 graph.is_constant(v.orbit->scale, 1) ? v.orbit->scale
                                                      : pow(Expr(graph, v.orbit->scale), power).id};
}

std::optional<Orbit> orbit_of_triplex_power(Lowering& lowering, const VectorValue& v, NodeId n,
                                            Expr around) {
    std::optional<Orbit> orbit = orbit_of_power(lowering, v, n);
    if (!orbit) return std::nullopt;
    Graph& graph = lowering.field.graph;
    const Expr degree(graph, n);
    const Expr along = pow(Expr(graph, length_of(lowering, v)), degree - 1.0);
    orbit->across = (degree * max(along, around) * Expr(graph, full_stretch(*v.orbit))).id;
    return orbit;
}

std::optional<Orbit> orbit_stretched(Lowering& lowering, const std::optional<Orbit>& orbit,
                                     NodeId factor) {
    if (!orbit) return std::nullopt;
    const TrimmedArithmetic calculate{lowering.field.graph};
    std::optional<NodeId> across;
    if (orbit->across) across = calculate.mul(factor, *orbit->across);
    return Orbit{calculate.mul(factor, orbit->stretch), orbit->degree, orbit->scale, across};
}

}  // namespace formula
