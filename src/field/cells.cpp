// SPDX-License-Identifier: MIT
#include "field/cells.h"

#include <algorithm>
#include <numbers>

#include "field/map_domain.h"
#include "graph/build.h"

namespace field {
namespace {

using graph::Expr;
using graph::NodeId;

/// Farther than any wall.
constexpr double no_wall = 1e30;
/// A slider may bring the size of a cell down to 0.
constexpr double least_size = 1e-30;

Expr nearest_whole(Expr number) { return floor(number + 0.5); }

/// One direction of a grid.
struct Axis {
    Expr inside;  ///< the coordinate within the cell
    Expr index;
    Expr to_upper, to_lower;  ///< ways to the walls
};

/// The size of a cell: 0 where nothing is repeated, and then another number to divide by.
struct Size {
    Expr step, divisor, half;
};

Axis endless(Expr x, const Size& size) {
    const Expr index = nearest_whole(x / size.divisor);
    const Expr inside = x - index * size.step;
    const Expr half = size.half;
    return {inside, index, half - inside, half + inside};
}

/// Cells 0 to n - 1, the outer ones without an end.
Axis counted(Expr x, const Size& size, Expr n) {
    graph::Graph& g = *x.graph;
    const Expr index = min(max(floor(x / size.divisor + n * 0.5), 0.0), n - 1.0);
    const Expr inside = x - (index - (n - 1.0) * 0.5) * size.step;
    const Expr half = size.half;
    const Expr far(g, no_wall);
    return {inside, index, select_less(index, n - 1.5, half - inside, far),
            select_less(Expr(g, 0.5), index, half + inside, far)};
}

}  // namespace

FieldId repeat(Field& field, FieldId a, const Point& cell, const std::optional<Point>& count) {
    graph::Graph& g = field.graph;
    Cells cells{.a = a, .point = coordinates(g), .walls = {}, .index = {}};
    for (std::size_t i = 0; i < 3; ++i) {
        if (g.is_constant(cell[i], 0)) continue;
        const Expr x(g, cells.point[i]), given(g, cell[i]);
        const bool known = g.is_constant(cell[i]);
        const Expr wide = select_less(Expr(g, least_size), given, given * 0.5, Expr(g, no_wall));
        const Size size{given, known ? given : max(given, least_size), known ? given * 0.5 : wide};
        const Axis axis = count ? counted(x, size, max(nearest_whole(Expr(g, (*count)[i])), 1.0))
                                : endless(x, size);
        cells.point[i] = axis.inside.id;
        cells.walls.push_back(axis.to_upper.id);
        cells.walls.push_back(axis.to_lower.id);
        cells.index.push_back(axis.index.id);
    }
    return cells.index.empty() ? a : field.add(std::move(cells));
}

FieldId repeat_polar(Field& field, FieldId a, NodeId count) {
    graph::Graph& g = field.graph;
    if (g.is_constant(count, 1)) return a;
    const Point here = coordinates(g);
    const Expr x(g, here[0]), y(g, here[1]), far(g, no_wall);
    const Expr n = max(nearest_whole(Expr(g, count)), 1.0);
    const Expr wedge = 2 * std::numbers::pi / n;
    const Expr number = nearest_whole(atan2(y, x) / wedge);
    const Expr c = cos(number * wedge), s = sin(number * wedge);
    const Expr qx = c * x + s * y, qy = c * y - s * x;
    const Expr along = sin(wedge * 0.5) * qx, across = cos(wedge * 0.5) * qy;
    // A single wedge has no walls.
    const auto wall = [&](Expr way) { return select_less(Expr(g, 1.5), n, way, far).id; };
    return field.add(Cells{.a = a,
                           .point = {qx.id, qy.id, here[2]},
                           .walls = {wall(along - across), wall(along + across)},
                           .index = {(number - n * floor(number / n)).id}});
}

FieldId mirror(Field& field, FieldId a, const Point& unit, NodeId d) {
    graph::Graph& g = field.graph;
    const Point here = coordinates(g);
    Expr in_front = -Expr(g, d);
    for (std::size_t i = 0; i < 3; ++i) {
        if (g.is_constant(unit[i], 0)) continue;
        in_front = in_front + Expr(g, unit[i]) * Expr(g, here[i]);
    }
    const Expr move = abs(in_front) - in_front;
    Point mirrored = here;
    for (std::size_t i = 0; i < 3; ++i) {
        if (g.is_constant(unit[i], 0)) continue;
        mirrored[i] = (Expr(g, here[i]) + Expr(g, unit[i]) * move).id;
    }
    if (!has_cells(field, a)) return bound_domain(field, a, mirrored, g.constant(1));
    return field.add(Cells{
        .a = a, .point = mirrored, .walls = {abs(in_front).id}, .index = {sign(in_front).id}});
}

}  // namespace field
