// SPDX-License-Identifier: MIT
// Fields that are moved, turned and made larger.
#include <gtest/gtest.h>

#include <cmath>

#include "field/blends.h"
#include "field/map_domain.h"
#include "field/shapes.h"
#include "graph/build.h"

namespace field {
namespace {

using graph::Expr;

struct Coordinates {
    Expr x, y, z;
};

Coordinates coordinates(Field& f) {
    return {{f.graph, f.graph.variable(graph::variable_x)},
            {f.graph, f.graph.variable(graph::variable_y)},
            {f.graph, f.graph.variable(graph::variable_z)}};
}

FieldId translated(Field& f, FieldId id, glm::dvec3 by) {
    const auto [x, y, z] = coordinates(f);
    return map_domain(f, id, {(x - by.x).id, (y - by.y).id, (z - by.z).id}, f.graph.constant(1));
}

FieldId scaled(Field& f, FieldId id, double factor) {
    const auto [x, y, z] = coordinates(f);
    return map_domain(f, id, {(x / factor).id, (y / factor).id, (z / factor).id},
                      f.graph.constant(factor));
}

/// A tree with every kind of node.
FieldId everything(Field& f) {
    const FieldId box = add_primitive(f, "box", {0.4, 0.9, 0.6});
    const FieldId onion = shells(f, 2);
    const FieldId sphere = add_primitive(f, "sphere", {0.8});
    const FieldId torus = add_primitive(f, "torus", {1, 0.3});
    const FieldId hollow = f.add(Intersection{onion, f.add(Complement{sphere})});
    const FieldId blend = smooth_union(f, shells(f, 1), torus, f.graph.constant(0.3));
    return f.add(Union{f.add(Union{box, hollow}), blend});
}

/// Fails unless the mapped field has at every point `stretch` times the value that the original
/// has at the point that `back` leads to.
template <class Back>
void expect_mapped(const Field& f, FieldId original, FieldId mapped, double stretch, Back back) {
    constexpr unsigned seed = 21;
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = random_point(random, 3);
        const double expected = stretch * eval::value(f, original, back(p), {});
        ASSERT_NEAR(eval::value(f, mapped, p, {}), expected, 1e-9)
            << "seed " << seed << ": " << describe(p);
    }
}

TEST(MapDomain, moves_every_kind_of_node) {
    Field f;
    const FieldId id = everything(f);
    const glm::dvec3 by(0.5, -1, 0.25);
    expect_mapped(f, id, translated(f, id, by), 1, [&](glm::dvec3 p) { return p - by; });
}

TEST(MapDomain, multiplies_distances_by_the_stretch) {
    Field f;
    const FieldId id = everything(f);
    expect_mapped(f, id, scaled(f, id, 2.5), 2.5, [](glm::dvec3 p) { return p / 2.5; });
}

TEST(MapDomain, turns_by_any_expressions_of_the_point) {
    Field f;
    const FieldId id = add_primitive(f, "box", {0.4, 0.9, 0.6});
    const auto [x, y, z] = coordinates(f);
    const double c = std::cos(0.7), s = std::sin(0.7);
    const FieldId turned =
        map_domain(f, id, {(c * x + s * y).id, (c * y - s * x).id, z.id}, f.graph.constant(1));
    expect_mapped(f, id, turned, 1, [&](glm::dvec3 p) {
        return glm::dvec3(c * p.x + s * p.y, c * p.y - s * p.x, p.z);
    });
}

TEST(MapDomain, replaces_all_coordinates_at_once) {
    Field f;
    const FieldId id = add_primitive(f, "box", {0.4, 0.9, 0.6});
    const auto [x, y, z] = coordinates(f);
    const FieldId cycled = map_domain(f, id, {y.id, z.id, x.id}, f.graph.constant(1));
    expect_mapped(f, id, cycled, 1, [](glm::dvec3 p) { return glm::dvec3(p.y, p.z, p.x); });
}

TEST(MapDomain, composes) {
    Field f;
    const FieldId id = everything(f);
    const glm::dvec3 by(0.5, -1, 0.25);
    const FieldId both = translated(f, scaled(f, id, 0.5), by);
    expect_mapped(f, id, both, 0.5, [&](glm::dvec3 p) { return (p - by) / 0.5; });
}

TEST(MapDomain, keeps_the_original_and_the_values_of_scalars) {
    Field f;
    const auto [x, y, z] = coordinates(f);
    const FieldId id = f.add(Formula{.value = (x * x + y - z).id, .kind = Kind::sheet});
    const FieldId larger = scaled(f, id, 4);
    EXPECT_EQ(eval::value(f, larger, {4, 8, 12}, {}), 0) << "1 + 2 - 3, not multiplied";
    EXPECT_EQ(eval::value(f, larger, {8, 8, 12}, {}), 3);
    EXPECT_EQ(eval::value(f, id, {2, 2, 3}, {}), 3);
    EXPECT_EQ(kind_of(f, larger), Kind::sheet);
}

}  // namespace
}  // namespace field
