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

/// Expressions of the point: where a map takes it.
using Point = std::array<graph::NodeId, 3>;
/// x, y and z: the map to itself.
Point coordinates(graph::Graph& graph);

/// Where a map takes the point: to `point`, turned about the z axis by `-turn` radians. Told apart
/// since a turn as such leaves lengths alone: what stretches them is the Jacobian of `point` plus
/// that of the angle times the way that it turns.
struct Image {
    Point point{};
    std::optional<graph::NodeId> turn{};
};

/// How a distance is distorted: it is one (1-Lipschitz) not in the point but in an image of it, and
/// `displacement`, an expression in the point, is added. The Lipschitz constant of the sum is at
/// most sup |J| + sup |grad displacement|, with J the Jacobian of the image.
struct Distortion {
    Image image{};
    std::optional<graph::NodeId> displacement;
};

/// So many operands are many: worth to be told apart from one another in cells of space.
inline constexpr std::size_t many = 16;

/// A minimum of many distances in the value of a formula.
struct Minimum {
    std::vector<graph::NodeId> operands;
    /// If given, it is the polynomial smooth minimum over this width, of one operand after the
    /// other (field::smooth_union).
    std::optional<graph::NodeId> width;
    graph::VariableId variable{};  ///< stands for it in the formula's outline
};

/// A leaf given by one expression in the point.
struct Formula {
    graph::NodeId value{};
    Metric metric = Metric::scalar;
    Kind kind = Kind::solid;
    std::optional<Colour> colour{};
    bool exact = false;  ///< the signed distance itself and not only a bound of it
    /// Of a scalar that is made of distorted distances: it changes by no more than that one of them
    /// which changes most. Empty if it is made of anything else, too.
    std::vector<Distortion> distortions{};
    /// Minima of many operands that the value is made of, as far as they are known, and the value
    /// as an expression of their variables.
    std::vector<Minimum> minima{};
    graph::NodeId outline{};  ///< if there are minima
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
    /// Where a map that is no isometry lies between the point and the distance: what it maps to.
    std::optional<Image> image{};
    /// Of the distance |z| log|z| / 2|z'|, how much of it can be relied on as that of numbers with
    /// |ab| = |a||b| can: 1 for those, whose |z'| is a bound, so that the surface is mostly twice
    /// as far, and of complex numbers, near the set, once to four times as far (Koebe's theorem;
    /// far from the set it is nearer). Less where |z'| leaves out that space is stretched more in
    /// some directions: the root of |z'| over what counts it at every turn. Heuristic, except for
    /// complex numbers.
    std::optional<graph::NodeId> evenness{};
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

/// A solid made of the values of solids by a formula. Only where an operand is no Formula;
/// otherwise all is composed into one Formula.
struct Blend {
    std::vector<FieldId> operands;
    /// One an operand: it stands for the operand's value in `value`.
    std::vector<graph::VariableId> values;
    /// Of `values` and parameters; changes by no more than that operand which changes most.
    graph::NodeId value{};
    std::optional<graph::NodeId> displacement{};  ///< added to it: an expression in the point
};

/// `a` where less < than, else `b`; both are the same at every point.
struct Choice {
    graph::NodeId less{}, than{};
    FieldId a{}, b{};
};

/// Copies of `a` in the cells of a partition of space. Within a cell everything is an isometry of
/// `a`'s own coordinates; across a wall the value may jump.
struct Cells {
    FieldId a{};
    Point point{};  ///< in the coordinates of `a`; its derivatives are those within the cell
    /// At least 0 inside the cell where the point is, at most 0 outside; affine within the cell.
    std::vector<graph::NodeId> walls;
    std::vector<graph::NodeId> index;  ///< at most three whole numbers that tell which cell it is
    std::optional<Colour> colour{};    ///< of all that is below, by the point outside of the cells
};

using Node =
    std::variant<Formula, Iteration, Union, Intersection, Complement, Blend, Choice, Cells>;

/// The value of an operand of a Blend that is undefined (outside, so positive) or that is inside
/// of an escape-time set (negative): farther than anything, but no infinity.
inline constexpr double unknown_depth = 1e30;

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

}  // namespace field
