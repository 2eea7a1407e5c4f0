// SPDX-License-Identifier: MIT
#include "oracle/shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "field/parts.h"
#include "graph/substitute.h"
#include "oracle/expressions.h"
#include "oracle/quadratic.h"
#include "oracle/unroll.h"
#include "oracle/zero_set.h"

namespace oracle {
namespace {

using field::FieldId;
using graph::NodeId;

/// Where a part of the tree stands: how it sees the point, and the walls of the cells around it.
struct Place {
    field::Point point{};
    std::vector<NodeId> walls{};
    bool moved = false;
};

/// What a node is: solids that are united, and sheets.
struct Union {
    std::vector<Part> parts;
    std::vector<Sheet> sheets;
};

void append(Union& list, Union more) {
    for (Part& part : more.parts) list.parts.push_back(std::move(part));
    for (Sheet& sheet : more.sheets) list.sheets.push_back(std::move(sheet));
}

class Builder {
public:
    Builder(const field::Field& field, std::span<const double> parameters)
        : field_(field), graph_(field.graph) {
        shape_.parameters.assign(parameters.begin(), parameters.end());
        shape_.parameters.resize(graph_.parameter_count(), 0.0);
    }

    Shape build() {
        const Union all = visit(field_.root, {field::coordinates(graph_)});
        shape_.parts = all.parts;
        shape_.sheets = all.sheets;
        expressions_.finish(shape_);
        return std::move(shape_);
    }

private:
    Union visit(FieldId id, const Place& place) {
        const field::Node node = field::shape(field_, id);
        return std::visit([&](const auto& it) { return visit_node(it, place); }, node);
    }

    Union visit_node(const field::Formula& node, const Place& place) {
        const int object = object_++;
        const NodeId value = seen(node.value, place);
        if (node.kind == field::Kind::solid) {
            return one({.what = Solid::What::formula,
                        .source = expressions_.add(value),
                        .distance = node.metric == field::Metric::distance,
                        .object = object},
                       place);
        }
        Union all;
        for (const ZeroSet& set : zero_sets(graph_, value)) {
            if (set.below) {
                append(all, one({.what = Solid::What::formula,
                                 .source = expressions_.add(set.zero),
                                 .object = object},
                                place));
                continue;
            }
            Sheet sheet{.source = expressions_.add(set.zero), .object = object};
            for (const NodeId guard : set.guards) sheet.guards.push_back(expressions_.add(guard));
            all.sheets.push_back(std::move(sheet));
        }
        return all;
    }
    Union visit_node(const field::Iteration& node, const Place& place) {
        if (const auto formula = unrolled(graph_, node, shape_.parameters, number(node.limit))) {
            return visit_node(*formula, place);
        }
        const auto tape = [&](std::span<const NodeId> roots) {
            return eval::make_tape(graph_, roots);
        };
        shape_.loops.push_back({node.state, tape(place.point), tape(node.start), tape(node.step),
                                node.escape ? tape(std::array{*node.escape}) : eval::Tape{},
                                tape(std::array{node.distance}), node.escape.has_value(),
                                std::round(number(node.limit))});
        shape_.loops.back().quadratic = quadratic_turns(node, place);
        return one({.what = Solid::What::loop,
                    .source = shape_.loops.size() - 1,
                    .object = object_++,
                    .has_loops = true,
                    .estimated = !shape_.loops.back().quadratic},
                   place);
    }
    std::optional<QuadraticTurns> quadratic_turns(const field::Iteration& node,
                                                  const Place& place) {
        const std::optional<Quadratic> turns = quadratic(graph_, node);
        if (!turns) return std::nullopt;
        std::vector<NodeId> roots = turns->start;
        roots.insert(roots.end(), turns->constant.begin(), turns->constant.end());
        roots.push_back(turns->minus_bound);
        for (NodeId& root : roots) root = seen(root, place);
        return QuadraticTurns{turns->start.size(), expressions_.add(roots)};
    }
    Union visit_node(const field::Union& node, const Place& place) {
        Union all = visit(node.a, place);
        append(all, visit(node.b, place));
        return all;
    }
    Union visit_node(const field::Intersection& node, const Place& place) {
        const Union a = visit(node.a, place), b = visit(node.b, place);
        Union all;
        if (!a.parts.empty() && !b.parts.empty()) {
            all = both(Solid::What::most, united(a), united(b));
        }
        append(all, {{}, clipped(a.sheets, b)});
        append(all, {{}, clipped(b.sheets, a)});
        return all;
    }
    Union visit_node(const field::Complement& node, const Place& place) {
        const Union list = visit(node.a, place);
        if (list.parts.empty()) return {};  // the language has no complement of a sheet
        const Part inner = united(list);
        return {{{add({.what = Solid::What::complement, .operands = {inner.solid}}), inner.walls}},
                {}};
    }
    Union visit_node(const field::Blend& node, const Place& place) {
        Solid blend{.what = Solid::What::blend, .values = node.values};
        std::vector<std::size_t> walls = walls_of(place);
        for (const FieldId operand : node.operands) {
            const Part part = united(visit(operand, place));
            blend.operands.push_back(part.solid);
            walls.insert(walls.end(), part.walls.begin(), part.walls.end());
        }
        std::vector<NodeId> roots{node.value};
        if (node.displacement) roots.push_back(seen(*node.displacement, place));
        blend.source = expressions_.add(roots);
        return {{{add(std::move(blend)), walls}}, {}};
    }
    Union visit_node(const field::Choice& node, const Place& place) {
        // The condition is the same at every point.
        const bool first = number(node.less) < number(node.than);
        if (!first) object_ += count(node.a);
        Union chosen = visit(first ? node.a : node.b, place);
        if (first) object_ += count(node.b);
        return chosen;
    }
    Union visit_node(const field::Cells& node, const Place& place) {
        Place inside = place;
        inside.moved = true;
        for (std::size_t i = 0; i < 3; ++i) inside.point[i] = seen(node.point[i], place);
        for (const NodeId wall : node.walls) inside.walls.push_back(seen(wall, place));
        return visit(node.a, inside);
    }

    /// The expression of the point as one of the point of the world.
    NodeId seen(NodeId id, const Place& place) {
        if (!place.moved) return id;
        const std::array<std::pair<graph::VariableId, NodeId>, 3> map{
            {{graph::variable_x, place.point[0]},
             {graph::variable_y, place.point[1]},
             {graph::variable_z, place.point[2]}}};
        return substitute(graph_, std::array{id}, map)[0];
    }
    int count(FieldId id) const { return static_cast<int>(leaves(field_, id).size()); }
    /// Of an expression that does not depend on the point.
    double number(NodeId id) const {
        return eval::evaluate(graph_, id, glm::dvec3(0), shape_.parameters);
    }
    std::size_t add(Solid solid) {
        for (const std::size_t operand : solid.operands) {
            solid.has_loops = solid.has_loops || shape_.solids[operand].has_loops;
            solid.estimated = solid.estimated || shape_.solids[operand].estimated;
        }
        // A blend calculates with how far, not only with the side.
        if (solid.what == Solid::What::blend && solid.has_loops) solid.estimated = true;
        shape_.solids.push_back(std::move(solid));
        return shape_.solids.size() - 1;
    }
    std::vector<std::size_t> walls_of(const Place& place) {
        std::vector<std::size_t> walls;
        for (const NodeId wall : place.walls) walls.push_back(expressions_.add(wall));
        return walls;
    }
    Union one(Solid solid, const Place& place) {
        return {{{add(std::move(solid)), walls_of(place)}}, {}};
    }
    Union both(Solid::What what, const Part& a, const Part& b) {
        std::vector<std::size_t> walls = a.walls;
        walls.insert(walls.end(), b.walls.begin(), b.walls.end());
        return {{{add({.what = what, .operands = {a.solid, b.solid}}), std::move(walls)}}, {}};
    }
    /// The solids of a union, at least one, as one.
    Part united(const Union& list) {
        Part all = list.parts.front();
        for (std::size_t i = 1; i < list.parts.size(); ++i) {
            all = both(Solid::What::least, all, list.parts[i]).parts.front();
        }
        return all;
    }
    std::vector<Sheet> clipped(std::vector<Sheet> sheets, const Union& by) {
        if (by.parts.empty()) return {};  // two sheets meet in curves, which are not drawn
        for (Sheet& sheet : sheets) {
            const std::size_t clip = united(by).solid;
            sheet.clip = sheet.clip
                             ? add({.what = Solid::What::most, .operands = {*sheet.clip, clip}})
                             : clip;
        }
        return sheets;
    }

    const field::Field& field_;
    graph::Graph graph_;
    Expressions expressions_{graph_};
    Shape shape_;
    int object_ = 0;
};

}  // namespace

bool is_heuristic(const Shape& shape) {
    const auto estimated = [&](std::size_t solid) { return shape.solids[solid].estimated; };
    return std::ranges::any_of(shape.parts,
                               [&](const Part& part) { return estimated(part.solid); }) ||
           std::ranges::any_of(shape.sheets, [&](const Sheet& sheet) {
               return sheet.clip && estimated(*sheet.clip);
           });
}

Shape make_shape(const field::Field& field, std::span<const double> parameters) {
    return Builder(field, parameters).build();
}

}  // namespace oracle
