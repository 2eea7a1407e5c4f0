// SPDX-License-Identifier: MIT
// Trees: kinds, leaves, and blends.
#include <gtest/gtest.h>

#include <cmath>

#include "field/blends.h"
#include "field/palette.h"
#include "field/shapes.h"
#include "graph/build.h"

namespace field {
namespace {

FieldId half_space(Field& f, graph::VariableId by, double at) {
    const graph::Expr value = graph::Expr(f.graph, f.graph.variable(by)) - at;
    return f.add(Formula{value.id, Metric::distance, Kind::solid});
}

FieldId sheet(Field& f) {
    return f.add(Formula{.value = f.graph.variable(graph::variable_x), .kind = Kind::sheet});
}

TEST(KindOf, is_a_sheet_where_any_visible_part_is_one) {
    Field f;
    const FieldId thin = sheet(f), solid = add_primitive(f, "sphere", {1});
    EXPECT_EQ(kind_of(f, thin), Kind::sheet);
    EXPECT_EQ(kind_of(f, solid), Kind::solid);
    EXPECT_EQ(kind_of(f, f.add(Union{solid, thin})), Kind::sheet);
    EXPECT_EQ(kind_of(f, f.add(Union{solid, solid})), Kind::solid);
    EXPECT_EQ(kind_of(f, f.add(Intersection{thin, solid})), Kind::sheet);
    EXPECT_EQ(kind_of(f, f.add(Complement{solid})), Kind::solid);
    EXPECT_EQ(kind_of(f, shells(f, 2)), Kind::solid);
}

TEST(Leaves, are_listed_from_left_to_right_and_as_often_as_they_are_used) {
    Field f;
    const FieldId a = sheet(f), b = add_primitive(f, "sphere", {1});
    const FieldId c = shells(f, 2);
    const FieldId left = f.add(Intersection{f.add(Complement{c}), a});
    const FieldId root = f.add(Union{left, smooth_union(f, b, c, f.graph.constant(1))});
    EXPECT_EQ(leaves(f, root), (std::vector{c, a, b, c}));
    EXPECT_EQ(leaves(f, a), std::vector{a});
}

/// Two half spaces at a right angle, blended over the width; of one graph, or of two leaves.
struct Pair {
    Field field;
    FieldId composed{}, apart{};

    explicit Pair(double width) {
        const FieldId a = half_space(field, graph::variable_x, 0);
        const FieldId b = half_space(field, graph::variable_y, 0);
        const graph::NodeId k = field.graph.constant(width);
        composed = smooth_union(field, a, b, k);
        // Colours keep formulas apart.
        apart = smooth_union(field, coloured(field, a, coordinates(field.graph)), b, k);
    }
    double at(double x, double y) const { return eval::value(field, composed, {x, y, 0}, {}); }
};

TEST(SmoothUnion, is_the_minimum_out_of_its_width) {
    const Pair blend(0.5);
    EXPECT_EQ(blend.at(2, 1), 1);
    EXPECT_EQ(blend.at(-3, 4), -3);
    EXPECT_EQ(blend.at(1, 1.5), 1);
}

TEST(SmoothUnion, is_a_quarter_of_the_width_lower_where_both_are_equal) {
    const Pair blend(0.5);
    EXPECT_DOUBLE_EQ(blend.at(1, 1), 1 - 0.125);
    EXPECT_DOUBLE_EQ(blend.at(0.1, 0.1), 0.1 - 0.125) << "the edge is filled";
    EXPECT_DOUBLE_EQ(blend.at(1, 1.25), 1 - 0.25 * 0.5 * 0.25);
}

TEST(SmoothUnion, is_the_same_in_one_graph_as_of_two_leaves) {
    constexpr unsigned seed = 31;
    Random random(seed);
    const Pair blend(0.75);
    ASSERT_TRUE(std::holds_alternative<Formula>(blend.field[blend.composed]));
    ASSERT_TRUE(std::holds_alternative<Blend>(blend.field[blend.apart]));
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 p = random_point(random, 1);
        ASSERT_NEAR(eval::value(blend.field, blend.composed, p, {}),
                    eval::value(blend.field, blend.apart, p, {}), 1e-14)
            << "seed " << seed << ": " << describe(p);
    }
}

TEST(SmoothUnion, composes_trees_of_solid_formulas) {
    Field f;
    const FieldId box = add_primitive(f, "box", {1, 1, 1});
    const FieldId hole = f.add(Complement{add_primitive(f, "sphere", {1.2})});
    const FieldId frame = f.add(Intersection{box, hole});
    const FieldId both = f.add(Union{frame, add_primitive(f, "torus", {1, 0.25})});
    const FieldId blend =
        smooth_union(f, both, add_primitive(f, "sphere", {0.5}), f.graph.constant(0.4));
    const auto* leaf = std::get_if<Formula>(&f[blend]);
    ASSERT_NE(leaf, nullptr);
    EXPECT_EQ(leaf->metric, Metric::distance);
    f.root = blend;
    expect_lipschitz(f, 32, 2, 2000);
}

TEST(SmoothUnion, of_an_escape_time_set_stays_a_tree) {
    Field f;
    f.root =
        smooth_union(f, shells(f, 2), add_primitive(f, "sphere", {1.1}), f.graph.constant(0.2));
    EXPECT_TRUE(std::holds_alternative<Blend>(f[f.root]));
    expect_lipschitz(f, 33, 2, 500);
}

TEST(SmoothUnion, of_a_scalar_promises_no_distance) {
    Field f;
    const FieldId scalar = f.add(Formula{.value = f.graph.variable(graph::variable_x)});
    const FieldId blend =
        smooth_union(f, scalar, add_primitive(f, "sphere", {1}), f.graph.constant(0.5));
    EXPECT_EQ(std::get<Formula>(f[blend]).metric, Metric::scalar);
}

/// A slider for the width may go down to 0.
TEST(SmoothUnion, is_the_plain_union_for_a_width_of_0) {
    Field f;
    const graph::NodeId k = f.graph.parameter(f.graph.new_parameter("k"));
    const FieldId a = half_space(f, graph::variable_x, 0);
    const FieldId b = half_space(f, graph::variable_y, 0);
    const FieldId onion = shells(f, 1);
    for (const FieldId blend : {smooth_union(f, a, b, k), smooth_union(f, onion, b, k)}) {
        for (const double width : {0.0, -1.0}) {
            const std::array parameters{0.0, width};
            EXPECT_EQ(eval::value(f, blend, {2, -3, 5}, parameters), -3);
            EXPECT_NEAR(eval::value(f, blend, {1.5, 1.5, 0}, parameters), 0.5, 1) << "no NaN";
        }
    }
}

}  // namespace
}  // namespace field
