// SPDX-License-Identifier: MIT
#include "formula/condition.h"

#include <gtest/gtest.h>

#include <cmath>

#include "formula/understood.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view errors) {
    EXPECT_EQ(errors_of(text), errors) << "formula: " << text;
}

TEST(Condition, is_any_comparison) {
    const auto chosen = [](const std::string& condition, double x) {
        return value_at("if(" + condition + ", 1, 2)", {x, 0, 0});
    };
    for (const double x : {-1.0, 0.0, 1.0}) {
        EXPECT_EQ(chosen("x < 0", x), x < 0 ? 1 : 2) << x;
        EXPECT_EQ(chosen("x <= 0", x), x <= 0 ? 1 : 2) << x;
        EXPECT_EQ(chosen("x > 0", x), x > 0 ? 1 : 2) << x;
        EXPECT_EQ(chosen("x >= 0", x), x >= 0 ? 1 : 2) << x;
        EXPECT_EQ(chosen("x = 0", x), x == 0 ? 1 : 2) << x;
        EXPECT_EQ(chosen("x > -2 & x < 1", x), x < 1 ? 1 : 2) << x;
        EXPECT_EQ(chosen("x < 0 | x > 0", x), x != 0 ? 1 : 2) << x;
        EXPECT_EQ(chosen("x < 1 \\ (x < 0 | x > 5)", x), x == 0 ? 1 : 2) << x;
        EXPECT_EQ(chosen("x", x), x > 0.5 ? 1 : 2) << x;
        EXPECT_TRUE(std::isnan(chosen("sqrt(-1) < x", x)));
    }
    EXPECT_EQ(value_at("choose(c, a, b) = if(c, a, b)\nchoose(x < 0, 1, 2)", {-1, 0, 0}), 1);
    EXPECT_EQ(value_at("if(sphere(1), 1, 2)", {0.5, 0, 0}), 1);
}

TEST(Condition, chooses_between_vectors) {
    EXPECT_EQ(value_at("v = if(x < 0, (1, 2), (3, 4))\nv.x + 10v.y", {-1, 0, 0}), 21);
    EXPECT_EQ(value_at("v = if(x < 0, (1, 2), (3, 4))\nv.x + 10v.y", {1, 0, 0}), 43);
    EXPECT_EQ(value_at("q = if(x < 0, complex(1, 2), (3, 4))^2\nq.x", {1, 0, 0}), -7);
}

TEST(Condition, refuses_what_cannot_be_chosen) {
    check("if(x < 0, 1)", "1:1: 'if' takes 3 arguments, not 2; write 'if(a < b, u, v)'");
    check("if(x < 0, 1, foo, 2)",
          "1:1: 'if' takes 3 arguments, not 4; write 'if(a < b, u, v)'\n"
          "1:14: unknown name 'foo'");
    check("if(x < 0, 1, (1, 2))",
          "1:1: both choices of 'if' must be of one type, not a number and a vector of 2");
    check(
        "if(x < 0, sphere(1), box())",
        "1:4: the condition of 'if' between fields must be the same at every point; write '(A & F) "
        "| (B \\ F)'");
    check("if(x < 0, sphere(1), 2)",
          "1:1: both choices of 'if' must be of one type, not a field and a number");
    check("if((1, 2), 1, 2)",
          "1:4: a vector of 2 cannot be a condition; write a comparison such as a < b");
    check("if(julia(), 1, 2)",
          "1:4: a field cannot be a condition; write a comparison such as a < b");
    check("if(sin, 1, 2)", "1:4: 'sin' needs its arguments in brackets; it is called 'sin(a)'");
    check("if((1, 2) < x, 1, 2)",
          "1:4: a vector of 2 cannot be used in a comparison; take its length(…) or a component "
          "such as .x");
}

}  // namespace
}  // namespace formula
