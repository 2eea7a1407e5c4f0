// SPDX-License-Identifier: MIT
#include "field/primitives.h"

#include <algorithm>
#include <array>

#include "graph/build.h"

namespace field {
namespace {

using graph::Expr;
using graph::NodeId;
using Arguments = std::span<const NodeId>;

struct Point {
    Expr x, y, z;
};

Point point_of(Field& field) {
    graph::Graph& g = field.graph;
    return {{g, g.variable(graph::variable_x)},
            {g, g.variable(graph::variable_y)},
            {g, g.variable(graph::variable_z)}};
}

/// The signed distance itself, which all primitives here compute.
FieldId distance(Field& field, Expr value) {
    return field.add(Formula{.value = value.id, .metric = Metric::distance, .exact = true});
}

/// The exact distance of a box in the plane from the signed distances to its two pairs of walls.
Expr rectangle(Expr a, Expr b) { return min(max(a, b), 0.0) + hypot(max(a, 0.0), max(b, 0.0)); }

FieldId sphere(Field& field, Arguments a) {
    const auto [x, y, z] = point_of(field);
    return distance(field, hypot(x, y, z) - Expr(field.graph, a[0]));
}

FieldId box(Field& field, Arguments a) {
    const auto [x, y, z] = point_of(field);
    const Expr qx = abs(x) - Expr(field.graph, a[0]);
    const Expr qy = abs(y) - Expr(field.graph, a[1]);
    const Expr qz = abs(z) - Expr(field.graph, a[2]);
    return distance(
        field, min(max(qx, max(qy, qz)), 0.0) + hypot(max(qx, 0.0), max(qy, 0.0), max(qz, 0.0)));
}

FieldId torus(Field& field, Arguments a) {
    const auto [x, y, z] = point_of(field);
    return distance(field,
                    hypot(hypot(x, y) - Expr(field.graph, a[0]), z) - Expr(field.graph, a[1]));
}

FieldId cylinder(Field& field, Arguments a) {
    const auto [x, y, z] = point_of(field);
    return distance(
        field, rectangle(hypot(x, y) - Expr(field.graph, a[0]), abs(z) - Expr(field.graph, a[1])));
}

FieldId cone(Field& field, Arguments a) {
    // In the half plane (rho, z): the distance to the base and to the slanted edge, whichever is
    // smaller, negative if the point is inside of both.
    const auto [x, y, z] = point_of(field);
    const Expr radius(field.graph, a[0]), half(field.graph, a[1]);
    const Expr rho = hypot(x, y);
    const Expr zero(field.graph, 0.0), one(field.graph, 1.0);
    const Expr base_rho = max(rho - radius, 0.0);
    const Expr base_z = z + half;
    const Expr square = radius * radius + 4.0 * half * half;
    const Expr along = ((half - z) * half * 2.0 + rho * radius) / square;
    const Expr part = min(max(along, 0.0), 1.0);
    const Expr edge_rho = rho - radius * part;
    const Expr edge_z = z - half + 2.0 * half * part;
    const Expr inside = select_less(edge_rho, zero, select_less(zero, base_z, -one, one), one);
    return distance(field, inside * min(hypot(base_rho, base_z), hypot(edge_rho, edge_z)));
}

FieldId capsule(Field& field, Arguments a) {
    const auto [x, y, z] = point_of(field);
    const Expr half(field.graph, a[1]);
    return distance(field, hypot(x, y, z - min(max(z, -half), half)) - Expr(field.graph, a[0]));
}

FieldId plane(Field& field, Arguments a) {
    const auto [x, y, z] = point_of(field);
    const Expr nx(field.graph, a[0]), ny(field.graph, a[1]), nz(field.graph, a[2]);
    const Expr length = hypot(nx, ny, nz);
    return distance(field,
                    nx / length * x + ny / length * y + nz / length * z - Expr(field.graph, a[3]));
}

/// (|a|^p + |b|^p)^(1/p) without large or tiny powers.
Expr norm(Expr a, Expr b, Expr p) {
    const Expr u = abs(a), v = abs(b), most = max(u, v);
    return most * pow(1.0 + pow(ratio(min(u, v), most), p), 1.0 / p);
}

FieldId superquadric(Field& field, Arguments a) {
    const auto [x, y, z] = point_of(field);
    const Expr p = max(Expr(field.graph, a[0]), 1.0), q = max(Expr(field.graph, a[1]), 1.0);
    // In the plane |v|_p changes by at most 2^(1/p - 1/2) a unit for p < 2, and by 1 above.
    const auto steepness = [&](Expr k) {
        return max(pow(Expr(field.graph, 2.0), 1.0 / k - 0.5), 1.0);
    };
    const Expr value = norm(norm(x, y, p), z, q) - 1.0;
    return field.add(
        Formula{.value = (value / (steepness(p) * steepness(q))).id, .metric = Metric::distance});
}

// Sorted by name.
const std::array<Primitive, 8> table{{
    {"box",
     {{"hx", {1}}, {"hy", {1}}, {"hz", {1}}},
     "A box by its half extents; exact distance.",
     box},
    {"capsule",
     {{"r", {0.5}}, {"h", {1}}},
     "All within r of the segment from z = -h to z = h; exact distance.",
     capsule},
    {"cone",
     {{"r", {1}}, {"h", {1}}},
     "A cone with its base of radius r at z = -h and its apex at z = h; exact distance.",
     cone},
    {"cylinder",
     {{"r", {0.5}}, {"h", {1}}},
     "A cylinder of radius r about the z axis from z = -h to z = h; exact distance.",
     cylinder},
    {"plane",
     {{"nx", {0}}, {"ny", {0}}, {"nz", {1}}, {"d", {0}}},
     "The half space below the plane with normal n (of any length) at the signed distance d from "
     "the origin; exact distance.",
     plane},
    {"sphere", {{"r", {1}}}, "A ball of radius r; exact distance.", sphere},
    {"superquadric",
     {{"p", {4}}, {"q", {4}}},
     "Between octahedron, ball and box: (|x|^p + |y|^p)^(q/p) + |z|^q <= 1 with p, q >= 1; a bound "
     "of the distance.",
     superquadric},
    {"torus",
     {{"R", {1}}, {"r", {0.35}}},
     "A torus about the z axis: a ring of radius R, r thick; exact distance.",
     torus},
}};

}  // namespace

std::span<const Primitive> primitives() { return table; }

const Primitive* find_primitive(std::string_view name) {
    const auto found = std::ranges::find(table, name, &Primitive::name);
    return found == table.end() ? nullptr : &*found;
}

}  // namespace field
