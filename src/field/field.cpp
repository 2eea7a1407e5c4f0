// SPDX-License-Identifier: MIT
#include "field/field.h"

#include <algorithm>
#include <utility>

#include "field/overloaded.h"
#include "graph/build.h"
#include "graph/substitute.h"

namespace field {
namespace {

using graph::NodeId;

/// Narrower than any pixel, and still no denormal number in single precision.
constexpr double least_width = 1e-30;

void collect_leaves(const Field& field, FieldId id, std::vector<FieldId>& list) {
    std::visit(Overloaded{[&](const Formula&) { list.push_back(id); },
                          [&](const Iteration&) { list.push_back(id); },
                          [&](const Complement& node) { collect_leaves(field, node.a, list); },
                          [&](const auto& node) {
                              collect_leaves(field, node.a, list);
                              collect_leaves(field, node.b, list);
                          }},
               field[id]);
}

/// A distance times the stretch; anything else keeps its value, whose sign is all that counts.
NodeId stretched(Field& field, NodeId value, NodeId stretch) {
    return field.graph.is_constant(stretch, 1) ? value
                                               : field.graph.apply(graph::Op::mul, value, stretch);
}

Colour mapped_colour(Field& field, const Colour& colour,
                     std::span<const std::pair<graph::VariableId, NodeId>> replacements) {
    const std::vector<NodeId> mapped = substitute(field.graph, colour, replacements);
    return {mapped[0], mapped[1], mapped[2]};
}

Node mapped_leaf(Field& field, const Formula& leaf,
                 std::span<const std::pair<graph::VariableId, NodeId>> replacements,
                 NodeId stretch) {
    Formula result = leaf;
    result.value = substitute(field.graph, std::array{leaf.value}, replacements)[0];
    if (leaf.metric == Metric::distance) result.value = stretched(field, result.value, stretch);
    if (leaf.colour) result.colour = mapped_colour(field, *leaf.colour, replacements);
    return result;
}

Node mapped_leaf(Field& field, const Iteration& leaf,
                 std::span<const std::pair<graph::VariableId, NodeId>> replacements,
                 NodeId stretch) {
    Iteration result = leaf;
    result.start = substitute(field.graph, leaf.start, replacements);
    result.step = substitute(field.graph, leaf.step, replacements);
    if (leaf.escape) {
        result.escape = substitute(field.graph, std::array{*leaf.escape}, replacements)[0];
    }
    result.distance = substitute(field.graph, std::array{leaf.distance}, replacements)[0];
    result.distance = stretched(field, result.distance, stretch);
    if (leaf.colour) result.colour = mapped_colour(field, *leaf.colour, replacements);
    return result;
}

/// The one expression of a tree of solid formulas, min and max for union and intersection; none if
/// the tree holds anything else, also where a colour would be lost.
std::optional<Formula> composed(Field& field, FieldId id) {
    const auto binary = [&](FieldId a_id, FieldId b_id, graph::Op op) -> std::optional<Formula> {
        const auto a = composed(field, a_id);
        const auto b = a ? composed(field, b_id) : std::nullopt;
        if (!b) return std::nullopt;
        const bool distances = a->metric == Metric::distance && b->metric == Metric::distance;
        return Formula{field.graph.apply(op, a->value, b->value),
                       distances ? Metric::distance : Metric::scalar, Kind::solid};
    };
    const Node node = field[id];
    return std::visit(Overloaded{
                          [](const Formula& leaf) -> std::optional<Formula> {
                              const bool plain = leaf.kind == Kind::solid && !leaf.colour;
                              return plain ? std::optional(leaf) : std::nullopt;
                          },
                          [&](const Union& u) { return binary(u.a, u.b, graph::Op::min); },
                          [&](const Intersection& i) { return binary(i.a, i.b, graph::Op::max); },
                          [&](const Complement& c) {
                              auto a = composed(field, c.a);
                              if (a) a->value = field.graph.apply(graph::Op::neg, a->value);
                              return a;
                          },
                          [](const auto&) -> std::optional<Formula> { return std::nullopt; },
                      },
                      node);
}

/// A blending width that is safe to divide by: a slider may go down to 0.
NodeId positive_width(Field& field, NodeId k) {
    if (field.graph.is_constant(k)) return k;
    return field.graph.apply(graph::Op::max, k, field.graph.constant(least_width));
}

}  // namespace

Kind kind_of(const Field& field, FieldId id) {
    const auto either = [&](FieldId a, FieldId b) {
        const bool sheet = kind_of(field, a) == Kind::sheet || kind_of(field, b) == Kind::sheet;
        return sheet ? Kind::sheet : Kind::solid;
    };
    return std::visit(Overloaded{[](const Formula& leaf) { return leaf.kind; },
                                 [&](const Union& node) { return either(node.a, node.b); },
                                 [&](const Intersection& node) { return either(node.a, node.b); },
                                 [](const auto&) { return Kind::solid; }},
                      field[id]);
}

std::vector<bool> needed_state(const graph::Graph& graph, const Iteration& iteration,
                               std::span<const NodeId> answers) {
    std::vector<bool> needed(iteration.state.size(), false);
    std::vector<NodeId> roots(answers.begin(), answers.end());
    if (iteration.escape) roots.push_back(*iteration.escape);
    // What a needed variable's step needs is needed too.
    while (!roots.empty()) {
        std::vector<NodeId> steps;
        for (const NodeId id : reachable(graph, roots)) {
            const graph::Node& node = graph[id];
            if (node.op != graph::Op::variable) continue;
            const auto variable = static_cast<graph::VariableId>(node.symbol);
            const auto found = std::ranges::find(iteration.state, variable);
            if (found == iteration.state.end()) continue;
            const auto i = static_cast<std::size_t>(found - iteration.state.begin());
            if (!needed[i]) steps.push_back(iteration.step[i]);
            needed[i] = true;
        }
        roots = std::move(steps);
    }
    return needed;
}

std::optional<Colour> colour_of(const Node& leaf) {
    if (const auto* formula = std::get_if<Formula>(&leaf)) return formula->colour;
    if (const auto* iteration = std::get_if<Iteration>(&leaf)) return iteration->colour;
    return std::nullopt;
}

std::vector<FieldId> leaves(const Field& field, FieldId id) {
    std::vector<FieldId> list;
    collect_leaves(field, id, list);
    return list;
}

FieldId map_domain(Field& field, FieldId id, const std::array<NodeId, 3>& point, NodeId stretch) {
    const std::array<std::pair<graph::VariableId, NodeId>, 3> replacements{
        {{graph::variable_x, point[0]},
         {graph::variable_y, point[1]},
         {graph::variable_z, point[2]}}};
    const Node node = field[id];  // a copy: adding nodes moves them
    const auto map = [&](FieldId child) { return map_domain(field, child, point, stretch); };
    Node result = std::visit(
        Overloaded{
            [&](const Union& n) -> Node {
                return Union{map(n.a), map(n.b)};
            },
            [&](const Intersection& n) -> Node {
                return Intersection{map(n.a), map(n.b)};
            },
            [&](const Complement& n) -> Node { return Complement{map(n.a)}; },
            [&](const SmoothUnion& n) -> Node {
                return SmoothUnion{map(n.a), map(n.b), stretched(field, n.k, stretch)};
            },
            [&](const auto& leaf) { return mapped_leaf(field, leaf, replacements, stretch); },
        },
        node);
    return field.add(std::move(result));
}

FieldId smooth_union(Field& field, FieldId a, FieldId b, NodeId k) {
    k = positive_width(field, k);
    const auto left = composed(field, a);
    const auto right = left ? composed(field, b) : std::nullopt;
    if (!right) return field.add(SmoothUnion{a, b, k});
    // h = max(k - |a - b|, 0) / k; min(a, b) - h^2 k / 4: the polynomial smooth minimum in a form
    // whose gradient is a convex combination of both gradients.
    graph::Graph& g = field.graph;
    const graph::Expr f(g, left->value), h(g, right->value), width(g, k);
    const graph::Expr overlap = max(width - abs(f - h), 0.0) / width;
    const graph::Expr blend = min(f, h) - overlap * overlap * width * 0.25;
    const bool distances = left->metric == Metric::distance && right->metric == Metric::distance;
    return field.add(Formula{blend.id, distances ? Metric::distance : Metric::scalar, Kind::solid});
}

}  // namespace field
