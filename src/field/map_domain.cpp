// SPDX-License-Identifier: MIT
#include "field/map_domain.h"

#include <algorithm>
#include <utility>

#include "field/overloaded.h"
#include "field/parts.h"
#include "graph/build.h"
#include "graph/substitute.h"

namespace field {
namespace {

using graph::NodeId;

/// Builds the tree seen through the map.
struct Mapping {
    Field& field;
    Point point;
    std::optional<NodeId> stretch;  ///< of a similarity; of others:
    Image image{};                  ///< what the map is for distortions
    bool scalars = false;           ///< whether scalars are multiplied like distances
    bool exact = true;              ///< whether a distance stays one

    void substitute(std::vector<NodeId*> places) const {
        const std::array<std::pair<graph::VariableId, NodeId>, 3> replacements{
            {{graph::variable_x, point[0]},
             {graph::variable_y, point[1]},
             {graph::variable_z, point[2]}}};
        std::vector<NodeId> roots;
        for (const NodeId* place : places) roots.push_back(*place);
        const std::vector<NodeId> mapped = graph::substitute(field.graph, roots, replacements);
        for (std::size_t i = 0; i < places.size(); ++i) *places[i] = mapped[i];
    }
    void multiply(NodeId& value) const {
        if (!stretch || field.graph.is_constant(*stretch, 1)) return;
        value = field.graph.apply(graph::Op::mul, value, *stretch);
    }
    void multiply(Point& image) const {
        for (NodeId& it : image) multiply(it);
    }

    FieldId operator()(FieldId id) const {
        Node node = field[id];  // a copy: adding nodes moves them
        substitute(expressions(node));
        const auto* cells = std::get_if<Cells>(&node);
        if (cells && !stretch) {
            return Mapping{field, cells->point, stretch, {cells->point}, scalars}(cells->a);
        }
        std::visit([&](auto& it) { finish(it); }, node);
        return field.add(std::move(node));
    }

    // What is left to do after the expressions are composed with the map. A distance is multiplied;
    // a scalar keeps its value, whose sign is all that counts, unless it is made of distances.
    void finish(Formula& leaf) const {
        const bool scalar = leaf.metric == Metric::scalar && leaf.distortions.empty();
        const bool multiplied = !scalar || scalars;
        if (multiplied && stretch) multiply_minima(leaf);
        // Their operands would be no distances.
        if (!multiplied || !stretch) leaf.minima.clear();
        leaf.exact = leaf.exact && exact && stretch;
        if (leaf.metric == Metric::distance && !stretch) {
            leaf.metric = Metric::scalar;
            leaf.distortions = {Distortion{image, {}}};
            return;
        }
        if (multiplied) multiply(leaf.value);
        for (Distortion& it : leaf.distortions) {
            multiply(it.image.point);
            if (it.displacement) multiply(*it.displacement);
        }
    }
    void multiply_minima(Formula& leaf) const {
        if (leaf.minima.empty() || field.graph.is_constant(*stretch, 1)) return;
        // What the outline adds belongs to values before they were multiplied.
        std::vector<std::pair<graph::VariableId, NodeId>> replacements;
        for (Minimum& minimum : leaf.minima) {
            for (NodeId& operand : minimum.operands) multiply(operand);
            if (minimum.width) multiply(*minimum.width);
            const NodeId variable = field.graph.variable(minimum.variable);
            replacements.emplace_back(minimum.variable,
                                      field.graph.apply(graph::Op::div, variable, *stretch));
        }
        const NodeId only = field.graph.variable(leaf.minima[0].variable);
        if (leaf.outline == only) return;
        leaf.outline = graph::substitute(field.graph, std::array{leaf.outline}, replacements)[0];
        multiply(leaf.outline);
    }
    void finish(Iteration& leaf) const {
        multiply(leaf.distance);
        if (leaf.image) {
            multiply(leaf.image->point);
        } else if (!stretch) {
            leaf.image = image;
        }
    }
    void finish(Union& node) const { node = {(*this)(node.a), (*this)(node.b)}; }
    void finish(Intersection& node) const { node = {(*this)(node.a), (*this)(node.b)}; }
    void finish(Complement& node) const { node.a = (*this)(node.a); }
    void finish(Choice& node) const {
        node.a = (*this)(node.a);
        node.b = (*this)(node.b);
    }
    void finish(Blend& node) const;
    void finish(Cells& node) const;
};

void Mapping::finish(Blend& node) const {
    // All operands are multiplied alike, so that they compare as before.
    const Mapping all{field, point, stretch, image, true, exact};
    for (FieldId& operand : node.operands) operand = all(operand);
    if (!stretch || field.graph.is_constant(*stretch, 1)) return;
    // What the blend adds and compares with belongs to values before they were multiplied.
    std::vector<std::pair<graph::VariableId, NodeId>> replacements;
    for (const graph::VariableId id : node.values) {
        replacements.emplace_back(
            id, field.graph.apply(graph::Op::div, field.graph.variable(id), *stretch));
    }
    node.value = graph::substitute(field.graph, std::array{node.value}, replacements)[0];
    multiply(node.value);
    if (node.displacement) multiply(*node.displacement);
}

void Mapping::finish(Cells& node) const {
    // The expressions are composed with the map already. What is within a cell is made larger in
    // the cell's own coordinates, so that the way there stays an isometry.
    multiply(node.point);
    for (NodeId& wall : node.walls) multiply(wall);
    if (field.graph.is_constant(*stretch, 1)) return;
    Point shrunk = coordinates(field.graph);
    for (NodeId& it : shrunk) it = field.graph.apply(graph::Op::div, it, *stretch);
    node.a = Mapping{field, shrunk, stretch, {}, scalars}(node.a);
}

}  // namespace

FieldId map_domain(Field& field, FieldId id, const Point& point, NodeId stretch) {
    return Mapping{field, point, stretch, {}, false}(id);
}

FieldId bound_domain(Field& field, FieldId id, const Point& point, NodeId stretch) {
    return Mapping{field, point, stretch, {}, false, false}(id);
}

FieldId distort_domain(Field& field, FieldId id, const Point& point) {
    return Mapping{field, point, std::nullopt, {point}, false}(id);
}

FieldId turn_domain(Field& field, FieldId id, NodeId angle) {
    graph::Graph& g = field.graph;
    const Point here = coordinates(g);
    const graph::Expr x(g, here[0]), y(g, here[1]), by(g, angle);
    const graph::Expr c = cos(by), s = sin(by);
    const Point turned{(c * x + s * y).id, (c * y - s * x).id, here[2]};
    return Mapping{field, turned, std::nullopt, {here, angle}, false}(id);
}

bool has_cells(const Field& field, FieldId id) {
    if (std::holds_alternative<Cells>(field[id])) return true;
    return std::ranges::any_of(children(field[id]),
                               [&](FieldId child) { return has_cells(field, child); });
}

}  // namespace field
