// SPDX-License-Identifier: MIT
// The functions that are generated for a field.
#include "shader/field_glsl.h"

#include <gtest/gtest.h>

#include "graph/build.h"
#include "shader/programs.h"

namespace shader {
namespace {

TEST(FieldGlsl, says_whether_a_leaf_has_edges) {
    EXPECT_TRUE(has(field_glsl(field_of("x = 1"), false).facts, "zs_has_edges = false;"));
    EXPECT_TRUE(has(field_glsl(field_of("sqrt(x) = 1"), false).facts, "zs_has_edges = true;"));
    EXPECT_TRUE(has(field_glsl(field_of("sphere(1) | (log(x) <= y)"), false).facts,
                    "zs_has_edges = true;"));
}

TEST(FieldGlsl, numbers_leaves_from_left_to_right) {
    const std::string code =
        field_glsl(field_of("sphere(1) | (box(1) \\ torus(1, 0.2))"), false).code;
    for (const char* leaf : {"leaf_0(", "leaf_1(", "leaf_2("}) EXPECT_TRUE(has(code, leaf)) << leaf;
    EXPECT_FALSE(has(code, "leaf_3("));
    EXPECT_LT(code.find("zs_hypot3"), code.find("value_1")) << "the sphere is the first";
}

TEST(FieldGlsl, asks_for_three_bounds_for_each_leaf_that_is_no_distance) {
    const auto count = [](const char* text) {
        return field_glsl(field_of(text), false).values.size();
    };
    EXPECT_EQ(count("sphere(1)"), 0U);
    EXPECT_EQ(count("x*y = z"), 3U);
    EXPECT_EQ(count("(x*y <= z) | (x <= y^2)"), 6U);
}

TEST(FieldGlsl, follows_polynomials_by_their_coefficients_only_if_asked_to) {
    const Demands along{.polynomials = true};
    const field::Field f = field_of("(x^2 + y^2)^3 = z");
    EXPECT_TRUE(has(field_glsl(f, false, along).code, "coefficients_0(real3 c, real3 e)"));
    EXPECT_TRUE(has(field_glsl(f, false, along).code, "a0_6 = scale * "));
    EXPECT_FALSE(has(field_glsl(f, false).code, "coefficients_0"));
    for (const char* other :
         {"x^13 = y", "x^2 = y", "sin(x) = y", "sphere(1)", "repeat(x^2 <= 0.1, (2, 2, 2))",
          "smooth_union(x^2 + y^2 <= 1, menger(1), 0.1)"}) {
        EXPECT_FALSE(has(field_glsl(field_of(other), false, along).code, "coefficients_")) << other;
    }
}

TEST(FieldGlsl, follows_no_polynomials_where_there_are_many) {
    std::string many = "x^3 + y^2 <= z";
    for (int i = 1; i < 17; ++i) many += " | x^3 + y^2 <= z + " + std::to_string(i);
    const Demands along{.polynomials = true};
    EXPECT_FALSE(has(field_glsl(field_of(many), false, along).code, "coefficients_"));
    const std::string few = "x^3 + y^2 <= z | x^3 + y^2 <= z + 1";
    EXPECT_TRUE(has(field_glsl(field_of(few), false, along).code, "coefficients_1(c, e);"));
}

TEST(FieldGlsl, remembers_sides_of_sheets_only) {
    EXPECT_TRUE(has(field_glsl(field_of("x*y = z"), false).code, "side_0 = now_0"));
    EXPECT_FALSE(has(field_glsl(field_of("x*y <= z"), false).code, "side_"));
}

TEST(FieldGlsl, counts_evaluations_only_if_asked_to) {
    const field::Field f = field_of("x*y = z");
    EXPECT_TRUE(has(field_glsl(f, true).code, "++zs_evaluations;"));
    EXPECT_FALSE(has(field_glsl(f, false).code, "zs_evaluations"));
}

TEST(FieldGlsl, takes_gradients_of_escaping_orbits_by_differences) {
    const FieldGlsl bulb = field_glsl(field_of("mandelbulb(8)"), false);
    EXPECT_TRUE(bulb.needs_differences);
    EXPECT_TRUE(has(bulb.code, "object_differences(object, p, h)"));
    EXPECT_FALSE(has(bulb.code, "gradient_0("));
    const FieldGlsl sphere = field_glsl(field_of("sphere(1)"), false);
    EXPECT_FALSE(sphere.needs_differences);
    EXPECT_FALSE(has(sphere.code, "object_differences"));
}

TEST(FieldGlsl, carries_gradients_where_that_takes_less_than_four_values) {
    for (const char* text : {"menger(2)", "sierpinski(3)", "translate(menger(2), (1, 0, 0))"}) {
        const FieldGlsl exact = field_glsl(field_of(text), false);
        EXPECT_FALSE(exact.needs_differences) << text;
        EXPECT_TRUE(has(exact.code, "g = gradient_0(")) << text;
    }
    // The march carries none of it.
    const std::string code = field_glsl(field_of("menger(2)"), false).code;
    EXPECT_FALSE(has(code.substr(0, code.find("gradient_0")), "next5"));
    // Of the components of a matrix product each depends on all.
    const FieldGlsl mixed = field_glsl(
        field_of("iterate p = (x, y, z) for 3:\n"
                 "    p = (p.x*p.y*p.z, (p.x + p.y)*p.z + p.x*p.y, p.x*(p.y - p.z) + p.z)\n"
                 "    distance = length(p) - 1"),
        false);
    EXPECT_TRUE(mixed.needs_differences);
}

TEST(FieldGlsl, takes_the_number_of_iterations_from_a_uniform) {
    EXPECT_TRUE(has(field_glsl(field_of("menger(2)"), false).code,
                    "int left = int(field_values[0].x + 0.5);"))
        << "a constant would be unrolled";
}

TEST(FieldGlsl, computes_once_what_does_not_change_from_step_to_step) {
    // The sponge's steps need the point's coordinates, but nothing else of the point.
    std::string code = field_glsl(field_of("translate(menger(2), (1, 0, 0))"), false).code;
    code.resize(code.find("gradient_0"));
    const std::size_t loop = code.find("while (");
    ASSERT_NE(loop, std::string::npos);
    EXPECT_LT(code.find("p.x - 1.0"), loop);
    EXPECT_EQ(code.find("p.x - 1.0", loop), std::string::npos);
}

TEST(FieldGlsl, makes_no_turn_in_vain) {
    // The escape and the next turn share the square of the orbit's length; the test ends the turn.
    const std::string code = field_glsl(field_of("julia((0, 0, 0, 0), 9)"), false).code;
    const std::size_t loop = code.find("while (true)");
    ASSERT_NE(loop, std::string::npos);
    const std::size_t test = code.find("if (--left <= 0 || !inside) break;", loop);
    ASSERT_NE(test, std::string::npos);
    EXPECT_EQ(code.find_first_not_of(" \n}", code.find(';', test) + 1), code.find("real", test))
        << "nothing of the turn stands behind the test";
    const std::string turn = code.substr(loop, test - loop);
    EXPECT_EQ(turn.find("sqrt"), std::string::npos) << turn;
    EXPECT_NE(turn.find("c0"), std::string::npos) << turn;
}

TEST(FieldGlsl, takes_care_of_nan_only_where_it_can_be) {
    const std::string sponge = field_glsl(field_of("menger(2)"), false).code;
    EXPECT_TRUE(has(sponge, "zs_greater("));
    EXPECT_FALSE(has(sponge, "zs_max("));
    const std::string cut = field_glsl(field_of("max(log(x), y) <= z"), false).code;
    EXPECT_TRUE(has(cut, "zs_max("));
    EXPECT_FALSE(has(cut, "zs_greater("));
}

TEST(FieldGlsl, has_colours_only_if_a_leaf_has_one) {
    field::Field f = field_of("sphere(1) | box(1)");
    EXPECT_FALSE(field_glsl(f, false).has_colours);
    EXPECT_FALSE(has(field_glsl(f, false).code, "object_colour"));
    const graph::NodeId x = f.graph.variable(graph::variable_x);
    std::get<field::Formula>(f.nodes[index(leaves(f, f.root)[1])]).colour = field::Colour{x, x, x};
    const FieldGlsl generated = field_glsl(f, false);
    EXPECT_TRUE(generated.has_colours);
    EXPECT_TRUE(has(generated.code, "real3 colour_1(real3 p) {\n    return real3(p.x, p.x, p.x);"));
    EXPECT_FALSE(has(generated.code, "colour_0("));
}

TEST(FieldGlsl, carries_state_only_where_it_is_needed) {
    field::Field f;
    const graph::VariableId orbit = f.graph.new_variable("u"), trap = f.graph.new_variable("trap");
    const graph::Expr u(f.graph, f.graph.variable(orbit)), least(f.graph, f.graph.variable(trap));
    f.root =
        f.add(field::Iteration{.state = {orbit, trap},
                               .start = {f.graph.variable(graph::variable_x), f.graph.constant(10)},
                               .step = {(2.0 * u).id, min(least, u).id},
                               .limit = f.graph.constant(4),
                               .escape = (u - 10.0).id,
                               .distance = u.id,
                               .colour = field::Colour{least.id, least.id, least.id}});
    const std::string code = field_glsl(f, false).code;
    const std::size_t colour = code.find("colour_0(");
    ASSERT_NE(colour, std::string::npos);
    EXPECT_LT(code.find("next0"), colour);
    EXPECT_GT(code.find("next1"), colour) << "the march needs no trap";
    EXPECT_NE(code.find("next1"), std::string::npos);
}

}  // namespace
}  // namespace shader
