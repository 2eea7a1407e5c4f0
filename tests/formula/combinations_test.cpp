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
          "1:1: an argument of 'smooth_union' is missing; it is called 'smooth_union(F, G, k = "
          "0.25)'");
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
    check("scale(sphere(1), (1, 2, 3))",
          "1:18: the argument 'factor' of 'scale' is one number, not a tuple");
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
