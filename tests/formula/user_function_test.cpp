// SPDX-License-Identifier: MIT
#include "formula/user_function.h"

#include <gtest/gtest.h>

#include "formula/understood.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view errors) {
    EXPECT_EQ(errors_of(text), errors) << "formula: " << text;
}

TEST(UserFunction, is_its_body_with_the_arguments_put_in) {
    EXPECT_EQ(value_of("f(a, b) = a + 10b\nf(1, 2)"), 21);
    EXPECT_EQ(value_of("f(a, b) = a + 10b\nf(b = 1, a = 2)"), 12);
    EXPECT_EQ(value_of("f(a, b = 3) = a + 10b\nf(1) + f(1, 2)"), 31 + 21);
    EXPECT_EQ(value_of("f(a) = a^2\ng(a) = f(a + 1) + f(a)\ng(2)"), 13);
    EXPECT_EQ(value_of("f(v) = dot(v, v)\nf((1, 2)) + f((1, 2, 3))"), 5 + 14);
    EXPECT_EQ(value_of("f(q) = q^2\nf(3) + f(complex(0, 2)).x"), 9 - 4);
    EXPECT_DOUBLE_EQ(value_at("ring(R, w) = torus(R, w) & (abs(z) <= w/2)\nring(2, 1)", {2, 0, 3}),
                     2.5);
    EXPECT_DOUBLE_EQ(
        value_at("twice(F) = F | translate(F, (3, 0, 0))\ntwice(sphere(1))", {3, 0, 0}), -1);
    EXPECT_DOUBLE_EQ(value_at("cut(F) = sphere(2) & F\ncut(x = 1)", {3, 0, 0}), 2);
}

TEST(UserFunction, hides_names_by_its_parameters_only_inside) {
    EXPECT_EQ(value_at("f(x, r) = x + 10r\nf(1, 2) + x + r", {0, 0, 5}), 26);
    EXPECT_EQ(value_at("f(y) = y + x\nf(10)", {1, 2, 3}), 11);
    EXPECT_EQ(value_of("a = 7\nf(a) = 2a\nf(1) + a"), 9);
    EXPECT_EQ(value_of("f(a) = 2a\ng(a) = f(1) + a\ng(5)"), 7);
}

TEST(UserFunction, knows_the_names_that_are_defined_above_it) {
    EXPECT_EQ(value_at("f(a) = a + r\nr = 100\nf(1) + r", {2, 3, 6}), 1 + 7 + 100);
    EXPECT_EQ(value_of("r = 100\nf(a) = a + r\nf(1)"), 101);
    EXPECT_EQ(value_of("k = 3\nf(a, b = k + 1) = a*b\ng(k) = f(k)\ng(2)"), 8);
    check("f(a) = a + k\nk = 2\nf(1) + k",
          "1:12: 'k' is defined further down, on line 2; move that line up");
    check("f(a, b = a) = a + b\nf(1)", "1:10: unknown name 'a'");
}

TEST(UserFunction, is_a_value) {
    EXPECT_EQ(value_of("f(a) = 2a\ng = f\ng(3)"), 6);
    EXPECT_EQ(value_of("twice(f, a) = f(f(a))\ndouble(a) = 2a\ntwice(double, 3)"), 12);
    EXPECT_EQ(value_of("twice(f, a) = f(f(a))\ntwice(sqrt, 16)"), 2);
    EXPECT_EQ(value_of("s = sin\ns(0) + 3"), 3);
    EXPECT_EQ(value_of("l = length\nl(v = (3, 4))"), 5);
    check("f(a) = a\nf + 1", "2:1: 'f' needs its arguments in brackets; it is called 'f(a)'");
    check("f(a, b = (1, 2)) = a*b\nf",
          "2:1: 'f' needs its arguments in brackets; it is called 'f(a, b = (1, 2))'");
    check("f(a) = a\nsphere(f)", "2:8: 'f' needs its arguments in brackets; it is called 'f(a)'");
    check("f(a) = a\n(f, 1).x", "2:2: 'f' needs its arguments in brackets; it is called 'f(a)'");
    check("f(a) = a\nf.x", "2:1: 'f' needs its arguments in brackets; it is called 'f(a)'");
    check("f(a) = a\nif(x < 1, f, 2)",
          "2:11: 'f' needs its arguments in brackets; it is called 'f(a)'");
}

TEST(UserFunction, reports_arguments_that_do_not_fit) {
    check("f(a, b) = a + b\nf(1)", "2:1: an argument of 'f' is missing; it is called 'f(a, b)'");
    check("f(a) = a\nf(1, 2)", "2:1: 'f' takes at most 1 argument, not 2; it is called 'f(a)'");
    check("f(size) = size\nf(sise = 2)", "2:3: 'f' has no argument 'sise'; did you mean 'size'?");
    check("f(a) = a\nf(1, a = 2)", "2:6: the argument 'a' of 'f' is given twice");
    check("f(a) = a\nf(foo)", "2:3: unknown name 'foo'");
}

TEST(UserFunction, is_checked_where_it_is_defined) {
    check("f(a) = a + foo\nx = 1", "1:12: unknown name 'foo'");
    check("f(a) = foo(a)\nx = 1", "1:8: unknown name 'foo'");
    check("f(a) = a + sphere(1)\nf(1)",
          "1:12: a field cannot be used in arithmetic; join fields with '|', '&' or '\\'");
    check("f(a) = tann(a)\nf(1) + f(2)", "1:8: unknown name 'tann'; did you mean 'tan'?");
}

TEST(UserFunction, has_errors_that_point_into_the_body_and_name_the_call) {
    check("f(a) = a^2\n\nf((1, 2))",
          "1:8: a vector of 2 has no powers; write dot(v, v) for the square of its length, or "
          "complex(v)^n (in the call of 'f' on line 3)");
    check("f(a) = 1 + a\ng(b) = f(b)\ng(sphere(1))",
          "1:12: a field cannot be used in arithmetic; join fields with '|', '&' or '\\' (in the "
          "call of 'f' on line 2, in the call of 'g' on line 3)");
    check("f(a) = dot(a, a)\nf(1) + f(2)",
          "1:8: 'dot' takes two vectors of one size, not a number and a number; it is called "
          "'dot(a, b)' (in the call of 'f' on line 2)");
    check(
        "a(p) = p.z\nb(p) = a(p)\nc(p) = b(p)\nd(p) = c(p)\ne(p) = d(p)\ne((1, 2))",
        "1:10: a vector of 2 has no component 'z'; its components are x, y (in the call of 'a' on "
        "line 2, in the call of 'b' on line 3, in the call of 'c' on line 4, in the call of 'd' on "
        "line 5, …)");
    check("f(g) = g(1)\nf(2)",
          "1:8: 'g' is not a function; write 'g*(…)' (in the call of 'f' on "
          "line 2)");
}

TEST(UserFunction, cannot_use_itself) {
    check("f(a) = f(a - 1)\nf(x)",
          "1:8: a definition cannot use itself: f → f; repeat with iterate");
    check("f(a) = g(a)\ng(a) = 1 + f(a)\nf(x) + g(x)",
          "1:8: a definition cannot use itself: f → g → f; repeat with iterate");
    check("f(a) = 2g(a)\ng(a) = h(a)\nh(b) = b + f(b)\nf(x) + h(x)",
          "1:9: a definition cannot use itself: f → g → h → f; repeat with iterate\n"
          "2:8: a definition cannot use itself: g → h → f → g; repeat with iterate");
    check("f(a) = g(a)\ng(a) = 1 + a\nf(x) + g(x)",
          "1:8: 'g' is defined further down, on line 2; move that line up");
    // A parameter of the same name, and a name in front of an argument, are no uses.
    check("f(a) = g(a)\ng(f) = f\nf(x) + g(x)",
          "1:8: 'g' is defined further down, on line 2; move that line up");
}

TEST(UserFunction, warns_of_parameters_and_functions_that_are_not_used) {
    EXPECT_EQ(report_of("f(a, b) = a\ng(c) = c\nf(x, y)"),
              "formula:1:6: warning: the parameter 'b' of 'f' is never used\n"
              "f(a, b) = a\n"
              "     ^\n"
              "formula:2:1: warning: the definition 'g' is never used\n"
              "g(c) = c\n"
              "^\n");
}

TEST(UserFunction, takes_primitives_and_combinations_as_arguments) {
    const std::string_view twice = "twice(F, d) = F(1) | translate(F(0.5), d)\ntwice(";
    EXPECT_EQ(value_at(std::string(twice) + "sphere, (0, 0, 2))", {0, 0, 3}), 0.5);
    EXPECT_EQ(value_at(std::string(twice) + "box, (0, 0, 2))", {0, 0, 4}), 1);
    const std::string_view join = "join(f) = f(sphere(1), translate(sphere(1), (3, 0, 0)))\njoin(";
    EXPECT_EQ(value_at(std::string(join) + "union)", {3, 0, 0}), -1);
    EXPECT_EQ(value_at(std::string(join) + "intersection)", {3, 0, 0}), 2);
    EXPECT_EQ(value_at("s = sphere\ns(r = 2)", {3, 0, 0}), 1);
}

}  // namespace
}  // namespace formula
