// SPDX-License-Identifier: MIT
#include "formula/combinations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "formula/understood.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view errors) {
    EXPECT_EQ(errors_of(text), errors) << "formula: " << text;
}

TEST(Combinations, are_sorted_by_name) {
    EXPECT_TRUE(std::ranges::is_sorted(combinations(), {}, &Combination::name));
}

TEST(Combinations, are_the_operators_by_name) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> coordinate(-2, 2);
    const std::pair<const char*, const char*> same[] = {
        {"union(sphere(1), box(), x <= 0)", "sphere(1) | box() | x <= 0"},
        {"intersection(sphere(1), box(0.8), x <= 0)", "sphere(1) & box(0.8) & x <= 0"},
        {"difference(sphere(1), x <= 0)", "sphere(1) \\ (x <= 0)"},
        {"sphere(1) & complement(x <= 0)", "sphere(1) \\ (x <= 0)"},
        {"complement(complement(sphere(1)))", "sphere(1)"},
        {"union(x = 1, r = 1)", "x = 1 | r = 1"},
    };
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 point{coordinate(random), coordinate(random), coordinate(random)};
        for (const auto& [named, written] : same) {
            EXPECT_EQ(value_at(named, point), value_at(written, point)) << named;
        }
    }
}

TEST(Combinations, smooth_union_blends_within_k) {
    const char* text = "smooth_union(sphere(1), plane(), k = 0.5)";
    EXPECT_DOUBLE_EQ(value_at(text, {0, 0, 3}), 2);
    EXPECT_DOUBLE_EQ(value_at("smooth_union(sphere(1), sphere(1), 0.5)", {3, 0, 0}), 2 - 0.125);
    EXPECT_DOUBLE_EQ(value_at("smooth_union(sphere(1), sphere(1))", {3, 0, 0}), 2 - 0.0625);
    check("smooth_union(sphere(1), x = 0)",
          "1:25: only solids can be blended; write '<=' instead of '='");
    check("smooth_union(sphere(1), box(), k = 0)",
          "1:36: the argument 'k' of 'smooth_union' must be above 0");
    check("smooth_union(sphere(1), box(), k = x)",
          "1:36: the argument 'k' of 'smooth_union' must not depend on x, y or z");
    check("smooth_union(sphere(1))",
          "1:1: an argument of 'smooth_union' is missing; it is called 'smooth_union(F, G, ..., "
          "k = 0.25)'");
}

TEST(Combinations, translate_moves) {
    EXPECT_DOUBLE_EQ(value_at("translate(sphere(1), (3, 0, 0))", {3, 2, 0}), 1);
    EXPECT_DOUBLE_EQ(value_at("translate(sphere(1), 3, 0, 0)", {3, 2, 0}), 1);
    EXPECT_DOUBLE_EQ(value_at("d = (0, 1, 2)\ntranslate(sphere(1), offset = d)", {0, 1, 2}), -1);
    EXPECT_DOUBLE_EQ(value_at("param a = 2\ntranslate(x = 0, (a, 0, 0))", {5, 0, 0}), 3);
    EXPECT_DOUBLE_EQ(value_at("translate(x, (1, 0, 0))", {5, 0, 0}), 4);
    check("translate(sphere(1), (1, 2))",
          "1:22: the argument 'offset' of 'translate' is a tuple of 3 numbers, not 2");
    check("translate(sphere(1), 1, y, 0)",
          "1:25: the argument 'dy' of 'translate' must not depend on x, y or z");
    check("translate(sphere(1))",
          "1:1: an argument of 'translate' is missing; it is called 'translate(F, (dx, dy, dz))'");
}

TEST(Combinations, rotate_turns_counter_clockwise_about_the_axis) {
    // The point that was at (1, 0, 0) is at (0, 1, 0) after a quarter turn about z.
    const char* quarter = "rotate(translate(sphere(0.5), (1, 0, 0)), (0, 0, 2), 90)";
    EXPECT_EQ(value_at(quarter, {0, 1, 0}), -0.5);
    EXPECT_EQ(value_at("rotate(x, (0, 0, 1), 90)", {0, 3, 0}), 3);
    EXPECT_EQ(value_at("rotate(y, (1, 0, 0), 90)", {0, 0, 3}), 3);
    EXPECT_EQ(value_at("rotate(z, (0, 1, 0), 90)", {3, 0, 0}), 3);
    EXPECT_EQ(value_at("rotate(x, (0, 0, 1), -90)", {0, 3, 0}), -3);
    EXPECT_EQ(value_at("rotate(x, (0, 0, 1), 180)", {3, 0, 0}), -3);
    EXPECT_EQ(value_at("rotate(x, (0, 0, 1), 270)", {0, 3, 0}), -3);
    EXPECT_NEAR(value_at("rotate(x, (0, 0, 1), 30)", {std::cos(std::numbers::pi / 6), 0.5, 0}), 1,
                1e-15);
    // A third of a turn about the diagonal takes x to y, y to z, z to x.
    EXPECT_NEAR(value_at("rotate(x + 10y + 100z, (1, 1, 1), 120)", {1, 2, 3}), 2 + 30 + 100, 1e-12);
}

TEST(Combinations, rotate_by_parameters_is_the_same_turn) {
    const char* constant = "rotate(x + 10y + 100z, (1, -2, 0.5), 77)";
    const char* varying =
        "param a = 77\nparam b = -2\nrotate(x + 10y + 100z, (1, b, 0.5), degrees = a)";
    const glm::dvec3 point{0.3, -1.2, 2.5};
    EXPECT_NEAR(value_at(constant, point), value_at(varying, point), 1e-12);
    check("rotate(sphere(1), (0, 0, 0), 3)", "1:19: the axis of 'rotate' must not be zero");
    check(
        "rotate(sphere(1), (0, 0, 1))",
        "1:1: an argument of 'rotate' is missing; it is called 'rotate(F, (nx, ny, nz), degrees)'");
}

TEST(Combinations, scale_keeps_distances) {
    EXPECT_DOUBLE_EQ(value_at("scale(sphere(1), 3)", {5, 0, 0}), 2);
    EXPECT_DOUBLE_EQ(value_at("param a = 3\nscale(box(), factor = a)", {5, 0, 0}), 2);
    EXPECT_DOUBLE_EQ(value_at("scale(x = 1, 3)", {3, 0, 0}), 0);
    check("scale(sphere(1), 0)", "1:18: the argument 'factor' of 'scale' must be above 0");
    check("scale(sphere(1), 1 - 2)", "1:18: the argument 'factor' of 'scale' must be above 0");
    check("scale(sphere(1), (1, 2))",
          "1:18: the argument 'factor' of 'scale' is a tuple of 3 numbers, not 2");
    check("scale(sphere(1), (1, 0, 3))", "1:18: the argument 'factor' of 'scale' must be above 0");
}

TEST(Combinations, scale_by_coordinates_gives_a_bound) {
    EXPECT_DOUBLE_EQ(value_at("scale(sphere(1), (2, 0.5, 1))", {4, 0, 0}), 0.5);
    EXPECT_DOUBLE_EQ(value_at("scale(sphere(1), (2, 0.5, 1))", {0, 1, 0}), 0.5);
    EXPECT_DOUBLE_EQ(value_at("param a = 2\nscale(x = 1, (a, 1, 1))", {4, 0, 0}), 1);
}

TEST(Combinations, blends_are_those_of_the_values) {
    EXPECT_NEAR(value_at("smooth_union_exp(sphere(1), sphere(1), k = 2)", {3, 0, 0}),
                2 - std::log(2.0) / 2, 1e-14);
    EXPECT_NEAR(value_at("smooth_union_power(sphere(1), sphere(1), p = 2)", {3, 0, 0}),
                std::sqrt(2.0), 1e-14);
    EXPECT_DOUBLE_EQ(value_at("smooth_intersection(sphere(1), sphere(1), 0.4)", {3, 0, 0}), 2.1);
    EXPECT_DOUBLE_EQ(value_at("smooth_difference(sphere(1), sphere(9), k = 0.4)", {3, 0, 0}), 6);
    EXPECT_DOUBLE_EQ(value_at("offset(sphere(1), d = 0.5)", {3, 0, 0}), 1.5);
    EXPECT_DOUBLE_EQ(value_at("shell(sphere(1), thickness = 0.5)", {0, 0, 0}), 0.75);
    EXPECT_DOUBLE_EQ(value_at("displace(sphere(1), x/4)", {3, 0, 0}), 2.75);
    EXPECT_DOUBLE_EQ(value_at("morph(sphere(1), sphere(2), 0.25)", {3, 0, 0}), 1.75);
    check("offset(x = 1, 0.1)", "1:8: only solids have an offset; write '<=' instead of '='");
    check("shell(x = 1)", "1:7: only solids have a shell; write '<=' instead of '='");
    check("displace(x, y)",
          "1:10: only solids can be displaced; write 'F <= 0' for the solid of a formula F");
    check("morph(sphere(1), x = 0, 0.5)",
          "1:18: only solids can be blended; write '<=' instead of '='");
    check("offset(sphere(1), x)",
          "1:19: the argument 'd' of 'offset' must not depend on x, y or z");
    check("displace(sphere(1), box())",
          "1:21: a field cannot be used as the argument 'by' of 'displace'; write a number in "
          "its place");
}

TEST(Combinations, twist_and_bend_turn_about_z) {
    const double quarter = std::numbers::pi / 2;
    const std::string turn = "twist(x = 0, " + std::to_string(quarter) + "z)";
    EXPECT_NEAR(value_at(turn, {0, 3, 1}), 3, 1e-5) << "as rotate does";
    EXPECT_NEAR(value_at(turn, {0, 3, 0}), 0, 1e-15);
    EXPECT_NEAR(value_at(turn, {0, 3, 2}), 0, 1e-4);
    // At the origin y = 0 bends into y = curvature x^2 / 2.
    const double h = 1e-3;
    EXPECT_NEAR(value_at("bend(y = 0, curvature = 0.8)", {h, 0.4 * h * h, 0}), 0, 1e-12);
    check("twist(sphere(1), box())",
          "1:18: a field cannot be used as the argument 'angle' of 'twist'; write a number in its "
          "place");
}

TEST(Combinations, mirror_keeps_the_side_of_the_normal) {
    const char* text = "mirror(translate(sphere(1), (3, 0, 0)), (1, 0, 0))";
    EXPECT_DOUBLE_EQ(value_at(text, {3, 0, 0}), -1);
    EXPECT_DOUBLE_EQ(value_at(text, {-3, 0, 0}), -1);
    EXPECT_DOUBLE_EQ(value_at("mirror(x + 10y, (0, -2, 0), d = 1)", {0, 2, 0}), -40)
        << "the plane is y = -1, and what is below it is kept";
    EXPECT_DOUBLE_EQ(value_at("mirror(x + 10y, (0, -2, 0), d = 1)", {0, -5, 0}), -50);
    check("mirror(sphere(1), (0, 0, 0))", "1:19: the normal of 'mirror' must not be zero");
}

TEST(Combinations, map_asks_the_field_at_another_place) {
    EXPECT_DOUBLE_EQ(value_at("wave(p) = (p.x, p.y + p.x^2, p.z)\nmap(y = 0, wave)", {3, 1, 0}),
                     10);
    check("f(p) = length(p)\nmap(sphere(1), f)",
          "2:16: a map of space must give a vector of 3, not a number");
    check("map(sphere(1), 3)", "1:16: a number is no function, so it cannot be a map of space");
}

TEST(Combinations, repeat_is_the_copy_in_the_cell) {
    const char* text = "repeat(sphere(0.5), (2, 0, 3))";
    EXPECT_DOUBLE_EQ(value_at(text, {0.25, 0, 0}), -0.25);
    EXPECT_DOUBLE_EQ(value_at(text, {-3.75, 0, 6}), -0.25);
    EXPECT_DOUBLE_EQ(value_at(text, {0, 4, 0}), 3.5) << "0 repeats nothing";
    const char* three = "repeat(sphere(0.5), cell = (2, 2, 2), count = (3, 2, 1))";
    EXPECT_DOUBLE_EQ(value_at(three, {2, 1, 0}), -0.5);
    EXPECT_DOUBLE_EQ(value_at(three, {-2, -1, 0}), -0.5);
    EXPECT_DOUBLE_EQ(value_at(three, {4, 1, 0}), 1.5) << "no fourth copy";
    EXPECT_DOUBLE_EQ(value_at(three, {0, 3, 0}), 1.5) << "an even number is centred too";
    EXPECT_DOUBLE_EQ(value_at("param c = 0\nrepeat(sphere(0.5), (c, 0, 0))", {4, 0, 0}), 3.5);
    EXPECT_DOUBLE_EQ(value_at("param c = 2\nrepeat(sphere(0.5), (c, 0, 0))", {4, 0, 0}), -0.5);
    check("repeat(sphere(1), (1, -1, 1))",
          "1:19: the argument 'cell' of 'repeat' must not be negative; 0 repeats nothing in its "
          "direction");
}

TEST(Combinations, repeat_polar_is_the_copy_in_the_wedge) {
    const char* text = "repeat_polar(translate(sphere(0.5), (2, 0, 0)), 3)";
    for (const double degrees : {0.0, 120.0, 240.0, -120.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        EXPECT_NEAR(value_at(text, {2 * std::cos(angle), 2 * std::sin(angle), 0.25}), -0.25, 1e-14);
    }
    EXPECT_NEAR(value_at(text, {-2, 0, 0}), std::sqrt(12.0) / 1.0 - 1.5, 2);
    EXPECT_DOUBLE_EQ(value_at("repeat_polar(x, 1)", {-3, 0, 0}), -3);
    EXPECT_DOUBLE_EQ(value_at("param n = 1\nrepeat_polar(x, n)", {-3, 1, 0}), -3);
    check("repeat_polar(sphere(1), 0)", "1:25: the argument 'n' of 'repeat_polar' must be above 0");
}

TEST(Combinations, colour_gives_a_colour_and_keeps_the_value) {
    EXPECT_DOUBLE_EQ(value_at("colour(sphere(1), (1, y, 0))", {3, 0, 0}), 2);
    EXPECT_DOUBLE_EQ(value_at("colour(sphere(1) | box(), c = x)", {3, 0, 0}), 2);
    const auto lowered = understand("colour(repeat(sphere(1), (3, 3, 3)), (1, y, 0)) | x = 1");
    ASSERT_TRUE(lowered);
    const auto& both = std::get<field::Union>(lowered->field[lowered->field.root]);
    EXPECT_TRUE(std::get<field::Cells>(lowered->field[both.a]).colour)
        << "the colour is a function of the point outside of the cells";
    check("colour(sphere(1), (1, 2))",
          "1:19: a colour is a number or (red, green, blue), not a vector of 2");
}

TEST(Combinations, if_chooses_between_fields) {
    const char* text = "param a = 1\nif(a > 2, sphere(1), box())";
    EXPECT_DOUBLE_EQ(value_at(text, {3, 0, 0}), 2);
    EXPECT_DOUBLE_EQ(value_at("param a = 3\nif(a > 2, sphere(1), x = 7)", {3, 0, 0}), 2);
}

TEST(Combinations, refuse_wrong_numbers_of_fields) {
    check("union(sphere(1))",
          "1:1: 'union' takes 2 or more fields, not 1; write 'union(F, G, ...)'");
    check("complement()", "1:1: 'complement' takes 1 field, not 0; write 'complement(F)'");
    check("difference(x <= 0, y <= 0, z <= 0)",
          "1:1: 'difference' takes 2 fields, not 3; write 'difference(F, G)'");
    check("union(sphere(1), (1, 2))",
          "1:18: a vector of 2 is no field; write an equation or a field");
}

}  // namespace
}  // namespace formula
