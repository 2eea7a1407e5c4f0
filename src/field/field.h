// SPDX-License-Identifier: MIT
// A scene's shape: a tree of set operations whose leaves hold graphs. f < 0 is inside, f = 0 the
// surface, f > 0 outside.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "field/parameter.h"
#include "graph/graph.h"

namespace field {

enum class FieldId : std::uint32_t {};
constexpr std::size_t index(FieldId id) { return static_cast<std::size_t>(id); }

/// A sheet is the surface f = 0, infinitely thin and without an inside; a solid is f <= 0.
enum class Kind { sheet, solid };

/// What the value of a leaf says about distance.
enum class Metric {
    scalar,    ///< only the sign and the zeros count; a Lipschitz constant must be found
    distance,  ///< a signed distance bound: 1-Lipschitz in the point
};

/// A leaf's own colour in place of its material's: red, green and blue, linear; negative and
/// undefined ones count as 0. Of the point, in an iteration also of the state after the last turn.
using Colour = std::array<graph::NodeId, 3>;

/// A leaf given by one expression in the point.
struct Formula {
    graph::NodeId value{};
    Metric metric = Metric::scalar;
    Kind kind = Kind::solid;
    std::optional<Colour> colour{};
    bool exact = false;  ///< the signed distance itself and not only a bound of it
    std::optional<base::SourceSpan> span{};  ///< of the comparison in the user's text
};

/// An escape-time leaf, always a solid. The state starts at `start` (of the point), and `step` (of
/// state and point, all at once) is repeated at most `limit` times, until `escape` > 0. If it
/// escaped, or if there is no `escape`, `distance` (of state and point) is the answer, a signed
/// estimate of the distance: heuristic unless the builder says otherwise. If it never escaped, the
/// point is inside, and nothing is known about how deep. State that no answer needs costs nothing:
/// see `needed_state`.
struct Iteration {
    std::vector<graph::VariableId> state;
    std::vector<graph::NodeId> start;
    std::vector<graph::NodeId> step;
    graph::NodeId limit{};  ///< independent of the point; rounded to the nearest whole number
    std::optional<graph::NodeId> escape;
    graph::NodeId distance{};
    std::optional<Colour> colour{};
};

struct Union {
    FieldId a{}, b{};
};
struct Intersection {
    FieldId a{}, b{};
};
struct Complement {
    FieldId a{};
};
/// Polynomial smooth minimum of two distances over a blending width k > 0; 1-Lipschitz if both are.
/// Only where an operand is no Formula; otherwise it is composed into one graph.
struct SmoothUnion {
    FieldId a{}, b{};
    graph::NodeId k{};
};

using Node = std::variant<Formula, Iteration, Union, Intersection, Complement, SmoothUnion>;

/// A whole shape: one graph for all leaves, the tree, the formula's parameters.
struct Field {
    graph::Graph graph;
    std::vector<Node> nodes;
    FieldId root{};
    std::vector<Parameter> parameters;

    FieldId add(Node node) {
        nodes.push_back(std::move(node));
        return static_cast<FieldId>(nodes.size() - 1);
    }
    const Node& operator[](FieldId id) const { return nodes[index(id)]; }
};

/// Sheet if any part that is visible as itself is a sheet.
Kind kind_of(const Field& field, FieldId id);

/// For each state variable of an iteration whether these expressions (of state and point), or the
/// escape, need its value.
std::vector<bool> needed_state(const graph::Graph& graph, const Iteration& iteration,
                               std::span<const graph::NodeId> answers);

/// The own colour of a leaf, if it has one.
std::optional<Colour> colour_of(const Node& leaf);

/// The leaves below a node from left to right: the objects of the scene. A leaf that is used twice
/// is listed twice.
std::vector<FieldId> leaves(const Field& field, FieldId id);

/// The same shape with x, y, z replaced by these expressions of the point, and distances multiplied
/// by `stretch` (independent of the point): the factor that makes a distance at the new point a
/// distance again, 1 for isometries, a for `x / a`.
FieldId map_domain(Field& field, FieldId id, const std::array<graph::NodeId, 3>& point,
                   graph::NodeId stretch);

/// The smooth union; composes graphs where both sides are made of formulas. A width that a
/// parameter brings down to 0 gives the plain union.
FieldId smooth_union(Field& field, FieldId a, FieldId b, graph::NodeId k);

}  // namespace field
