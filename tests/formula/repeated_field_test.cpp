// SPDX-License-Identifier: MIT
// Unions of what a function gives for 1, 2, 3 and so on.
#include <gtest/gtest.h>

#include "formula/understood.h"

namespace formula {
namespace {

const std::string ball = "ball(i) = translate(sphere(0.1i), (i, 0, 0))\n";

TEST(RepeatedField, is_the_union_of_its_copies) {
    const std::string written = ball + "union(ball(1), ball(2), ball(3))";
    for (const glm::dvec3 point : {glm::dvec3(0), {2.2, 0.1, 0}, {3, 0, 0.2}, {9, 0, 0}}) {
        EXPECT_EQ(value_at(ball + "union(ball, 3)", point), value_at(written, point));
        EXPECT_EQ(
            value_at(ball + "smooth_union(ball, 3, 1)", point),
            value_at(ball + "smooth_union(smooth_union(ball(1), ball(2), 1), ball(3), 1)", point));
        EXPECT_EQ(value_at(ball + "smooth_union(ball, 3)", point),
                  value_at(ball + "smooth_union(ball(1), ball(2), ball(3), k = 0.25)", point));
    }
    EXPECT_DOUBLE_EQ(value_at(ball + "union(ball, 1)", {1, 0, 0}), -0.1);
}

TEST(RepeatedField, may_choose_by_the_number) {
    const std::string text =
        "thing(i) = translate(if(mod(i, 2) < 1, box(0.1, 0.1, 0.1), sphere(0.1)), "
        "(i, 0, 0))\nunion(thing, 4)";
    EXPECT_DOUBLE_EQ(value_at(text, {1, 0.2, 0}), 0.1);
    EXPECT_DOUBLE_EQ(value_at(text, {2, 0.1, 0}), 0);
}

TEST(RepeatedField, needs_a_known_number_of_copies) {
    const std::string problem =
        "the argument 'n' of 'union' must be a whole number from 1 to "
        "10,000, the same for all parameters";
    EXPECT_EQ(errors_of(ball + "union(ball, 2.5)"), "2:13: " + problem);
    EXPECT_EQ(errors_of(ball + "union(ball, 0)"), "2:13: " + problem);
    EXPECT_EQ(errors_of("param n = 3\n" + ball + "union(ball, n)"), "3:13: " + problem);
}

TEST(RepeatedField, needs_a_function_that_gives_fields) {
    EXPECT_EQ(errors_of("f(i) = 2i\nunion(f, 3)"),
              "2:7: 'f' must give a field for each number, not a number");
}

TEST(RepeatedField, is_of_solids_where_it_is_blended) {
    EXPECT_EQ(errors_of("f(i) = x = i\nsmooth_union(f, 3)"),
              "2:14: only solids can be blended; write 'F <= 0' for the solid of a formula F");
    EXPECT_EQ(errors_of("f(i) = x = i\nunion(f, 3)"), "");
}

}  // namespace
}  // namespace formula
