// SPDX-License-Identifier: MIT
#include "formula/arguments.h"

#include <gtest/gtest.h>

#include "formula/understood.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view errors) {
    EXPECT_EQ(errors_of(text), errors) << "formula: " << text;
}

TEST(Arguments, are_given_by_place_or_by_name) {
    EXPECT_DOUBLE_EQ(value_at("sphere(2)", {5, 0, 0}), 3);
    EXPECT_DOUBLE_EQ(value_at("sphere(r = 2)", {5, 0, 0}), 3);
    EXPECT_DOUBLE_EQ(value_at("sphere()", {5, 0, 0}), 4);
    EXPECT_DOUBLE_EQ(value_at("box(1, 2, 3)", {0, 5, 0}), 3);
    EXPECT_DOUBLE_EQ(value_at("box(1, hz = 3)", {0, 0, 5}), 2);
    EXPECT_DOUBLE_EQ(value_at("box(hz = 3, hx = 2)", {5, 0, 0}), 3);
    EXPECT_DOUBLE_EQ(value_at("torus(2, 0.5)", {2, 0, 2}), 1.5);
    EXPECT_DOUBLE_EQ(value_at("plane(0, 0, 2, 1)", {0, 0, 3}), 2);
}

TEST(Arguments, may_be_parameters_and_tuples) {
    EXPECT_DOUBLE_EQ(value_at("param a = 2\nsphere(a^2)", {5, 0, 0}), 1);
    const double direct = value_at("julia((-0.2, 0.6, 0.2, 0.2))", {1, 1, 1});
    EXPECT_EQ(value_at("c = (-0.2, 0.6, 0.2, 0.2)\njulia(c)", {1, 1, 1}), direct);
    EXPECT_EQ(value_at("julia(c = (-0.2, 0.6, 0.2, 0.2), iterations = 11, slice = 0)", {1, 1, 1}),
              direct);
    EXPECT_EQ(value_at("julia()", {1, 1, 1}), direct);
    EXPECT_NE(value_at("julia((0.3, 0.6, 0.2, 0.2))", {1, 1, 1}), direct);
}

TEST(Arguments, that_do_not_fit_are_errors) {
    check("sphere(radius = 2)",
          "1:8: 'sphere' has no argument 'radius'; it is called 'sphere(r = 1)'");
    check("julia(slcie = 2)", "1:7: 'julia' has no argument 'slcie'; did you mean 'slice'?");
    check("sphere(r = 1, r = 2)", "1:15: the argument 'r' of 'sphere' is given twice");
    check("sphere(1, r = 2)", "1:11: the argument 'r' of 'sphere' is given twice");
    check("box(hx = 1, 2)",
          "1:13: an argument without a name cannot follow one with a name; name it too");
    check("sphere(1, 2)",
          "1:1: 'sphere' takes at most 1 argument, not 2; it is called 'sphere(r = 1)'");
    check("torus(1, 2, 3)",
          "1:1: 'torus' takes at most 2 arguments, not 3; it is called 'torus(R = 1, r = 0.35)'");
    check("julia(c = (1, 2, 3))",
          "1:11: the argument 'c' of 'julia' is a tuple of 4 numbers, not 3");
    check("julia(2)", "1:7: the argument 'c' of 'julia' is a tuple of 4 numbers, not 1");
    check("sphere((1, 2))", "1:8: the argument 'r' of 'sphere' is one number, not a tuple");
    check("sphere(sphere(1))", "1:8: the argument 'r' of 'sphere' is a number, not a field");
    check("julia(sphere(1))", "1:7: the argument 'c' of 'julia' is a tuple, not a field");
    check("sphere(x)", "1:8: the argument 'r' of 'sphere' must not depend on x, y or z");
    check("sphere(1/0)", "1:8: the argument 'r' of 'sphere' is not a finite number");
    check("sphere(sqrt(-1))", "1:8: the argument 'r' of 'sphere' is not a finite number");
}

TEST(Arguments, that_do_not_fit_do_not_hide_errors_inside) {
    check("sphere(foo, bar)",
          "1:1: 'sphere' takes at most 1 argument, not 2; it is called 'sphere(r = 1)'\n"
          "1:8: unknown name 'foo'\n"
          "1:13: unknown name 'bar'");
}

TEST(Arguments, tuples_hold_numbers) {
    check("((1, 2), 3)",
          "1:2: a vector of 2 cannot be used in a tuple; take its length(…) or a component such as "
          ".x");
    check("(1, 2, 3, 4, 5)", "1:1: a vector has at most four components");
    check("c = (1, sphere(1))\njulia(c)",
          "1:9: a field cannot be used in a tuple; write a number in its place");
    check("(1, 2)", "1:1: a vector of 2 is no field; write an equation or a field");
}

}  // namespace
}  // namespace formula
