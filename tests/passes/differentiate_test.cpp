// SPDX-License-Identifier: MIT
// Derivatives at kinks, and gradients of distances.
#include "passes/differentiate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "eval/tape.h"
#include "field/blends.h"
#include "field/primitives.h"
#include "passes/rule.h"

namespace passes {
namespace {

/// The derivative by x at x = 0, y = 0.
double slope_at_0(Expr f) {
    graph::Graph& graph = *f.graph;
    return eval::evaluate(graph, differentiate(graph, f.id, graph::variable_x), {0, 0, 0});
}

TEST(Differentiate, is_zero_by_structure_where_nothing_depends) {
    Leaves l;
    const graph::NodeId slope = differentiate(l.graph, (log(l.y) * l.t).id, graph::variable_x);
    EXPECT_TRUE(l.graph.is_constant(slope, 0));
}

TEST(Differentiate, takes_the_first_argument_of_equal_ones) {
    Leaves l;
    EXPECT_EQ(slope_at_0(min(2.0 * l.x, 3.0 * l.x)), 2);
    EXPECT_EQ(slope_at_0(max(2.0 * l.x, 3.0 * l.x)), 2);
    EXPECT_EQ(slope_at_0(max(3.0 * l.x, 2.0 * l.x)), 3);
}

TEST(Differentiate, is_zero_at_the_kink_of_an_absolute_value) {
    Leaves l;
    EXPECT_EQ(slope_at_0(abs(l.x)), 0);
}

TEST(Differentiate, does_not_see_jumps) {
    Leaves l;
    EXPECT_EQ(slope_at_0(sign(l.x)), 0);
    EXPECT_EQ(slope_at_0(floor(l.x)), 0);
    EXPECT_EQ(slope_at_0(apply(Op::ceil, l.x)), 0);
}

TEST(Differentiate, follows_the_branch_of_a_choice) {
    Leaves l;
    const Expr choice = select_less(l.x, l.number(0), 5.0 * l.x, 7.0 * l.x);
    EXPECT_EQ(slope_at_0(choice), 7);
}

TEST(Differentiate, keeps_powers_of_negative_bases) {
    Leaves l;
    const Expr power = pow(l.x - 2.0, l.t);
    const graph::NodeId slope = differentiate(l.graph, power.id, graph::variable_x);
    EXPECT_DOUBLE_EQ(eval::evaluate(l.graph, slope, {0, 0, 0}, std::array{3.0}), 12);
}

std::array<double, 3> gradient_at(graph::Graph& graph, graph::NodeId f, glm::dvec3 point) {
    std::array<double, 3> values{};
    const auto slopes = gradient(graph, f);
    for (std::size_t i = 0; i < 3; ++i) values[i] = eval::evaluate(graph, slopes[i], point);
    return values;
}

TEST(Gradient, of_a_length_is_zero_at_zero) {
    Leaves l;
    const Expr length = hypot(l.x, l.y, l.z);
    EXPECT_EQ(gradient_at(l.graph, length.id, {0, 0, 0}), (std::array<double, 3>{0, 0, 0}));
    EXPECT_EQ(gradient_at(l.graph, length.id, {0, -3, 4}), (std::array<double, 3>{0, -0.6, 0.8}));
    EXPECT_EQ(gradient_at(l.graph, hypot(l.x, l.z).id, {0, 5, 0}),
              (std::array<double, 3>{0, 0, 0}));
}

TEST(Gradient, of_a_box_is_a_unit_vector_inside_and_outside) {
    field::Field f;
    const field::Primitive* box = field::find_primitive("box");
    ASSERT_NE(box, nullptr);
    const std::array sides{f.graph.constant(1), f.graph.constant(2), f.graph.constant(3)};
    const graph::NodeId value = std::get<field::Formula>(f[box->build(f, sides)]).value;
    for (const glm::dvec3 point :
         {glm::dvec3(0.5, 0.2, 0.1), glm::dvec3(-0.9, 1.2, 2), glm::dvec3(0.1, -1.8, 2.5),
          glm::dvec3(0.3, 0.2, 2.9), glm::dvec3(4, 1, 0), glm::dvec3(-2, 5, 7)}) {
        const auto g = gradient_at(f.graph, value, point);
        EXPECT_NEAR(std::hypot(g[0], g[1], g[2]), 1, 1e-14)
            << point.x << ", " << point.y << ", " << point.z;
    }
    EXPECT_EQ(gradient_at(f.graph, value, {-0.9, 0, 0}), (std::array<double, 3>{-1, 0, 0}));
}

TEST(Differentiate, twice_a_box_has_no_nan_inside) {
    field::Field f;
    const field::Primitive* box = field::find_primitive("box");
    ASSERT_NE(box, nullptr);
    const graph::NodeId one = f.graph.constant(1);
    const graph::NodeId value =
        std::get<field::Formula>(f[box->build(f, std::array{one, one, one})]).value;
    for (const graph::VariableId by : {graph::variable_x, graph::variable_y, graph::variable_z}) {
        const graph::NodeId first = differentiate(f.graph, value, by);
        for (const graph::VariableId again : {graph::variable_x, graph::variable_y}) {
            const graph::NodeId second = differentiate(f.graph, first, again);
            EXPECT_EQ(eval::evaluate(f.graph, second, {0.5, -0.2, 0.1}), 0);
            EXPECT_EQ(eval::evaluate(f.graph, second, {0.9, 0.1, 0.2}), 0);
        }
    }
}

TEST(Gradient, of_a_power_blend_is_that_of_the_nearer_solid_inside) {
    field::Field f;
    const graph::NodeId one = f.graph.constant(1);
    const auto plane = [&](double nx, double ny) {
        const std::array numbers{f.graph.constant(nx), f.graph.constant(ny), f.graph.constant(0),
                                 f.graph.constant(0)};
        return field::find_primitive("plane")->build(f, numbers);
    };
    const field::FieldId blend = field::smooth_union_power(f, plane(1, 0), plane(0, 1),
                                                           f.graph.apply(graph::Op::add, one, one));
    const graph::NodeId value = std::get<field::Formula>(f[blend]).value;
    EXPECT_EQ(gradient_at(f.graph, value, {-2, -1, 0}), (std::array<double, 3>{1, 0, 0}));
    EXPECT_EQ(gradient_at(f.graph, value, {-2, 3, 0}), (std::array<double, 3>{1, 0, 0}));
}

TEST(Gradient, passes_through_the_passes) {
    Leaves l;
    const auto slopes = gradient(l.graph, (l.x * l.x + 3.0 * l.y).id);
    EXPECT_EQ(in_one_line(l.graph, slopes[0]), "mul(2, x)");
    EXPECT_EQ(in_one_line(l.graph, slopes[1]), "3");
    EXPECT_EQ(in_one_line(l.graph, slopes[2]), "0");
}

}  // namespace
}  // namespace passes
