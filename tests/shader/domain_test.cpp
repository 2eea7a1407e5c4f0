// SPDX-License-Identifier: MIT
// Which expressions may be undefined.
#include "shader/domain.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "shader/programs.h"

namespace shader {
namespace {

bool may_be_undefined(std::string_view text) {
    const field::Field f = field_of(text);
    return shader::may_be_undefined(f.graph, std::array{std::get<field::Formula>(f[f.root]).value});
}

TEST(MayBeUndefined, is_false_where_every_operator_has_a_value_everywhere) {
    EXPECT_FALSE(may_be_undefined("x^3 + y*z - 1 = 0"));
    EXPECT_FALSE(may_be_undefined("sin(x) + cos(y) + atan(z) + atan2(x, y) = 0"));
    EXPECT_FALSE(may_be_undefined("exp(x) + sinh(y) + tanh(z) + cbrt(x) = 1"));
    EXPECT_FALSE(may_be_undefined("abs(x) + floor(y) + sign(z) + max(x, y) = 1"));
    EXPECT_FALSE(may_be_undefined("sqrt(x^2 + y^2) + hypot(x, z) + r = 1")) << "lengths";
    EXPECT_FALSE(may_be_undefined("sphere(1)"));
}

TEST(MayBeUndefined, is_true_with_a_pole_or_an_edge) {
    for (const char* text :
         {"1/x = y", "sqrt(x) = y", "log(x) = y", "asin(x) = y", "acos(x) = y", "tan(x) = y",
          "x^2.5 = y", "x^-1 = y", "x^y = z", "mod(x, y) = z", "x^0.5 = y"}) {
        EXPECT_TRUE(may_be_undefined(text)) << text;
    }
}

TEST(MayBeUndefined, does_not_mind_division_by_a_number) {
    EXPECT_FALSE(may_be_undefined("x/3 = y"));
    EXPECT_FALSE(may_be_undefined("mod(x, 2) = y"));
    EXPECT_TRUE(may_be_undefined("x/0 = y"));
}

TEST(MayBeUndefined, does_not_mind_what_is_the_same_for_all_points) {
    EXPECT_FALSE(may_be_undefined("param a = 1 in [0, 2]\nx = sqrt(a) + log(a) + 1/a"));
    EXPECT_TRUE(may_be_undefined("param a = 1 in [0, 2]\nx/a = 1")) << "a may be 0";
}

/// Whether the value of a formula, or some step of an iteration, may be NaN.
bool may_be_nan(std::string_view text) {
    const field::Field f = field_of(text);
    const std::vector<bool> may = shader::may_be_nan(f);
    if (const auto* leaf = std::get_if<field::Formula>(&f[f.root])) return may[index(leaf->value)];
    return std::ranges::any_of(std::get<field::Iteration>(f[f.root]).step,
                               [&](graph::NodeId step) { return may[index(step)]; });
}

TEST(MayBeNan, is_false_where_every_operator_is_a_number) {
    EXPECT_FALSE(may_be_nan("max(x, abs(y), floor(z)) + r + sin(x)/3 <= 1"));
    EXPECT_FALSE(may_be_nan("x/max(y^2, 0.1) <= 1"));
    EXPECT_FALSE(may_be_nan("menger(3)"));
    EXPECT_FALSE(may_be_nan("mandelbox()"));
}

TEST(MayBeNan, is_true_beyond_a_domain) {
    for (const char* text : {"x/y <= 1", "x/max(y, -1) <= 1", "sqrt(x) <= 1", "log(x) <= 1",
                             "max(x, y^2.5) <= 1", "param a = 1\nx*sqrt(a) <= 1"}) {
        EXPECT_TRUE(may_be_nan(text)) << text;
    }
}

TEST(MayBeNan, goes_from_turn_to_turn) {
    // The first turn makes v NaN, and only the next one makes u so.
    EXPECT_TRUE(
        may_be_nan("iterate u = x, v = y for 3:\n    u = u + v\n    v = log(v)\n    "
                   "distance = u"));
    EXPECT_FALSE(
        may_be_nan("iterate u = x, v = y for 3:\n    u = u + v\n    v = 2v\n    "
                   "distance = u"));
}

}  // namespace
}  // namespace shader
