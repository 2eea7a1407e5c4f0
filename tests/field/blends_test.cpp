// SPDX-License-Identifier: MIT
// What blends make of values, and that they change no faster than these.
#include "field/blends.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "field/palette.h"
#include "field/shapes.h"
#include "graph/build.h"

namespace field {
namespace {

using graph::Expr;
using graph::NodeId;

/// An operation on two fields by one number.
using Operation = FieldId (*)(Field&, FieldId, FieldId, NodeId);

FieldId offset_first(Field& f, FieldId a, FieldId, NodeId d) { return offset(f, a, d); }
FieldId shell_first(Field& f, FieldId a, FieldId, NodeId d) { return shell(f, a, d); }

const Operation operations[] = {
    smooth_union,      smooth_union_exp, smooth_union_power, smooth_intersection,
    smooth_difference, offset_first,     shell_first,        morph};

/// A field whose value is the coordinate: of one graph, or, with a colour, apart from others.
FieldId coordinate(Field& f, graph::VariableId by) {
    return f.add(Formula{f.graph.variable(by), Metric::distance});
}
FieldId coordinate_apart(Field& f, graph::VariableId by) {
    return coloured(f, coordinate(f, by), coordinates(f.graph));
}

/// The operation on x and y.
double applied(Operation operation, double number, double x, double y) {
    Field f;
    const FieldId a = coordinate(f, graph::variable_x), b = coordinate(f, graph::variable_y);
    f.root = operation(f, a, b, f.graph.constant(number));
    return value(f, {x, y, 0});
}

TEST(SmoothUnionExp, is_the_logarithm_of_a_sum) {
    for (const double x : {-1.0, 0.0, 0.3}) {
        for (const double y : {-0.5, 0.2, 1.0}) {
            const double expected = -std::log(std::exp(-5 * x) + std::exp(-5 * y)) / 5;
            EXPECT_NEAR(applied(smooth_union_exp, 5, x, y), expected, 1e-14);
        }
    }
    EXPECT_EQ(applied(smooth_union_exp, 8, 1e4, 1e5), 1e4) << "does not overflow";
    EXPECT_EQ(applied(smooth_union_exp, 8, -1e5, -1e4), -1e5);
}

TEST(SmoothUnionPower, is_the_norm_where_both_are_positive) {
    const double expected = std::pow(std::pow(0.3, -4) + std::pow(0.5, -4), -0.25);
    EXPECT_NEAR(applied(smooth_union_power, 4, 0.3, 0.5), expected, 1e-15);
    EXPECT_EQ(applied(smooth_union_power, 4, -0.3, 0.5), -0.3);
    EXPECT_EQ(applied(smooth_union_power, 4, -0.3, -0.5), -0.5);
    EXPECT_EQ(applied(smooth_union_power, 4, 0, 0.5), 0);
    EXPECT_EQ(applied(smooth_union_power, 4, 0, 0), 0);
    EXPECT_EQ(applied(smooth_union_power, 4, 1e-200, 1), 1e-200) << "does not vanish";
}

TEST(SmoothIntersection, is_a_quarter_of_the_width_higher_where_both_are_equal) {
    EXPECT_DOUBLE_EQ(applied(smooth_intersection, 0.4, 1, 1), 1 + 0.1);
    EXPECT_EQ(applied(smooth_intersection, 0.4, 1, 2), 2);
    EXPECT_DOUBLE_EQ(applied(smooth_difference, 0.4, 1, -1), 1 + 0.1);
    EXPECT_EQ(applied(smooth_difference, 0.4, -1, 2), -1);
    EXPECT_EQ(applied(smooth_difference, 0.4, -2, -1), 1);
}

TEST(Offset, and_shell_are_counted_from_the_surface) {
    EXPECT_DOUBLE_EQ(applied(offset_first, 0.25, 1, 0), 0.75);
    EXPECT_DOUBLE_EQ(applied(shell_first, 0.5, 1, 0), 0.75);
    EXPECT_DOUBLE_EQ(applied(shell_first, 0.5, -1, 0), 0.75);
    EXPECT_DOUBLE_EQ(applied(shell_first, 0.5, 0.1, 0), -0.15);
}

TEST(Morph, goes_from_one_to_the_other_and_no_further) {
    EXPECT_DOUBLE_EQ(applied(morph, 0.25, 1, 5), 2);
    EXPECT_EQ(applied(morph, 0, 1, 5), 1);
    EXPECT_EQ(applied(morph, -3, 1, 5), 1);
    EXPECT_EQ(applied(morph, 7, 1, 5), 5);
}

TEST(Blends, are_the_same_in_one_graph_as_of_fields_apart) {
    constexpr unsigned seed = 41;
    Random random(seed);
    for (std::size_t i = 0; i < std::size(operations); ++i) {
        Field f;
        const NodeId k = f.graph.parameter(f.graph.new_parameter("k"));
        const FieldId a = coordinate(f, graph::variable_x), b = coordinate(f, graph::variable_y);
        const FieldId composed = operations[i](f, a, b, k);
        const FieldId sponge = shells(f, 1);
        const FieldId apart =
            operations[i](f, f.add(Union{a, f.add(Intersection{a, sponge})}), b, k);
        ASSERT_TRUE(std::holds_alternative<Formula>(f[composed])) << i;
        EXPECT_EQ(std::get<Formula>(f[composed]).metric, Metric::distance) << i;
        ASSERT_TRUE(std::holds_alternative<Blend>(f[apart])) << i;
        for (int n = 0; n < 200; ++n) {
            const glm::dvec3 p = random_point(random, 2);
            const std::array parameters{0.0, std::abs(random_point(random, 2).x)};
            ASSERT_NEAR(eval::value(f, composed, p, parameters),
                        eval::value(f, apart, p, parameters), 1e-13)
                << "operation " << i << ", seed " << seed << ": " << describe(p);
        }
    }
}

TEST(Blends, change_by_no_more_than_the_operand_that_changes_most) {
    for (std::size_t i = 0; i < std::size(operations); ++i) {
        for (const double k : {0.05, 0.7, 3.0}) {
            Field f;
            const FieldId box = add_primitive(f, "box", {0.4, 0.9, 0.6});
            f.root = operations[i](f, add_primitive(f, "sphere", {0.8}), box, f.graph.constant(k));
            expect_lipschitz(f, 42, 2, 400);
            f.root = operations[i](f, shells(f, 2), box, f.graph.constant(k));
            ASSERT_TRUE(std::holds_alternative<Blend>(f[f.root]));
            expect_lipschitz(f, 43, 2, 100);
        }
    }
}

TEST(Displace, adds_to_the_value_and_remembers_by_how_much) {
    Field f;
    const Expr x(f.graph, f.graph.variable(graph::variable_x));
    const FieldId solid = displace(f, add_primitive(f, "sphere", {1}), (x * 0.5).id);
    EXPECT_DOUBLE_EQ(eval::value(f, solid, {2, 0, 0}, {}), 2);
    const auto& leaf = std::get<Formula>(f[solid]);
    EXPECT_EQ(leaf.metric, Metric::scalar);
    ASSERT_EQ(leaf.distortions.size(), 1U);
    EXPECT_EQ(leaf.distortions[0].displacement, (x * 0.5).id);
    const FieldId shell = displace(f, shells(f, 0), (x * 0.5).id);
    EXPECT_DOUBLE_EQ(eval::value(f, shell, {2, 0, 0}, {}), 2);
    EXPECT_EQ(std::get<Blend>(f[shell]).displacement, (x * 0.5).id);
}

TEST(Distortions, go_through_blends_until_something_else_joins) {
    Field f;
    const Expr x(f.graph, f.graph.variable(graph::variable_x));
    const FieldId sphere = add_primitive(f, "sphere", {1});
    const FieldId bumpy = displace(f, sphere, x.id);
    const NodeId k = f.graph.constant(0.2);
    const auto count = [&](FieldId id) { return std::get<Formula>(f[id]).distortions.size(); };
    EXPECT_EQ(count(offset(f, bumpy, k)), 1U);
    EXPECT_EQ(count(smooth_union(f, bumpy, sphere, k)), 2U) << "the plain distance counts too";
    EXPECT_EQ(count(smooth_union(f, bumpy, bumpy, k)), 1U);
    const FieldId scalar = f.add(Formula{.value = (x * x).id});
    EXPECT_EQ(count(smooth_union(f, bumpy, scalar, k)), 0U);
    EXPECT_EQ(count(smooth_union(f, sphere, sphere, k)), 0U) << "a distance";
}

TEST(Choose, is_one_of_both_by_the_condition) {
    Field f;
    const NodeId a = f.graph.parameter(f.graph.new_parameter("a"));
    const FieldId sphere = add_primitive(f, "sphere", {1}),
                  box = add_primitive(f, "box", {1, 1, 1});
    const FieldId either = choose(f, a, f.graph.constant(2), sphere, box);
    EXPECT_DOUBLE_EQ(eval::value(f, either, {2, 2, 0}, std::array{0.0, 1.0}), std::sqrt(8.0) - 1);
    EXPECT_DOUBLE_EQ(eval::value(f, either, {2, 2, 0}, std::array{0.0, 2.0}), std::sqrt(2.0));
    const FieldId sheet =
        f.add(Formula{.value = f.graph.variable(graph::variable_x), .kind = Kind::sheet});
    EXPECT_EQ(kind_of(f, either), Kind::solid);
    EXPECT_EQ(kind_of(f, choose(f, a, a, sphere, sheet)), Kind::sheet);
    const FieldId rounded = offset(f, either, f.graph.constant(0.5));
    EXPECT_TRUE(std::holds_alternative<Formula>(f[rounded]));
    EXPECT_DOUBLE_EQ(eval::value(f, rounded, {2, 2, 0}, std::array{0.0, 2.0}),
                     std::sqrt(2.0) - 0.5);
}

TEST(Blends, keep_a_colour_that_all_operands_share) {
    Field f;
    const FieldId red = coordinate_apart(f, graph::variable_x);
    const FieldId blue = coordinate_apart(f, graph::variable_y);
    const NodeId k = f.graph.constant(1);
    EXPECT_TRUE(std::holds_alternative<Formula>(f[smooth_union(f, red, blue, k)]));
    EXPECT_TRUE(std::get<Formula>(f[offset(f, red, k)]).colour);
    const FieldId plain = coordinate(f, graph::variable_z);
    EXPECT_TRUE(std::holds_alternative<Blend>(f[smooth_union(f, red, plain, k)]));
}

}  // namespace
}  // namespace field
