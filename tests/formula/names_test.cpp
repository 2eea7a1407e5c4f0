// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "formula/understood.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view errors) {
    EXPECT_EQ(errors_of(text), errors) << "formula: " << text;
}

TEST(Names, an_unknown_one_is_shown_with_the_name_that_was_meant) {
    EXPECT_EQ(report_of("x + y + sine(z) = 0"),
              "formula:1:9: error: unknown name 'sine'; did you mean 'sin'?\n"
              "x + y + sine(z) = 0\n"
              "        ^~~~\n");
    check("(sine)", "1:2: unknown name 'sine'; did you mean 'sin'?");
    check("size = 2\nx + siez", "2:5: unknown name 'siez'; did you mean 'size'?");
    check("foo", "1:1: unknown name 'foo'");
    check("ln(x)", "1:1: unknown name 'ln'; did you mean 'log'?");
    check("Sphere(1)", "1:1: unknown name 'Sphere'; did you mean 'sphere'?");
}

TEST(Names, products_without_a_sign_get_a_hint) {
    check("xy = 1", "1:1: unknown name 'xy'; write 'x*y' for a product");
    check("2xyz", "1:2: unknown name 'xyz'; write 'x*y*z' for a product");
    check("x2 = 1", "1:1: unknown name 'x2'; write 'x^2' for a power or 'x*2' for a product");
}

TEST(Names, all_errors_are_reported_in_the_order_of_the_text) {
    check("a = foo + bar\nb = a + 2baz\nquux*a + b*(1 + foo)",
          "1:5: unknown name 'foo'\n"
          "1:11: unknown name 'bar'\n"
          "2:10: unknown name 'baz'\n"
          "3:1: unknown name 'quux'\n"
          "3:17: unknown name 'foo'");
}

TEST(Names, errors_of_form_and_of_meaning_are_reported_together) {
    check("a = foo\nb = 2 3\nc = a + b + bar\nx = y +",
          "1:5: unknown name 'foo'\n"
          "2:7: no operator between '2' and '3'; write '2*3' for a product\n"
          "3:13: unknown name 'bar'\n"
          "4:8: expected an expression after '+'");
}

TEST(Names, a_broken_definition_causes_no_further_errors) {
    check("a = 2 3\nb = a(x) + sin(a)\njulia(a) | sphere(b) & b",
          "1:7: no operator between '2' and '3'; write '2*3' for a product");
    check("param a = 1 in [3, 2]\nsphere(a) | x = a",
          "1:17: the range of 'a' is empty; write the smaller number first");
}

TEST(Names, definitions_are_used_from_the_next_line_on) {
    check("a = b\nb = 1\na + b + x",
          "1:5: 'b' is defined further down, on line 2; move that line up");
    check("a = a + 1\nx = a", "1:5: a definition cannot use itself: a → a; repeat with iterate");
    check("x = 2a\na = 1\ny = a",
          "1:1: 'x' is a coordinate and cannot be redefined\n"
          "1:6: 'a' is defined further down, on line 2; move that line up");
}

TEST(Names, a_last_line_that_defines_a_name_gets_a_hint) {
    check(
        "a = 1\nb = 2",
        "2:1: unknown name 'b'; to define it, type an equation such as x^2 + y^2 + z^2 = 1 on the "
        "next line");
}

TEST(Names, definitions_hide_built_in_names_but_not_coordinates) {
    EXPECT_EQ(value_of("r = 0.5\ne = 2\npi = 3\nr + e + pi"), 5.5);
    EXPECT_EQ(value_of("t = 4\ntau = 5\nsin = 2\nt + tau + sin"), 11);
    EXPECT_EQ(value_of("step = 2\nin = 3\nparam = 4\nstep + in + param"), 9);
    EXPECT_EQ(value_at("r = 2r\nr", {3, 0, 0}), 6);
    check("x = 1\ny = 2", "1:1: 'x' is a coordinate and cannot be redefined");
    check("param z = 1\nx = y", "1:7: 'z' is a coordinate and cannot be redefined");
}

TEST(Names, are_defined_once) {
    check("a = 1\n\na = 2\nx = a", "3:1: 'a' is already defined on line 1; choose another name");
    check("param a = 1\na = 2\nx = a",
          "2:1: 'a' is already defined on line 1; choose another name");
    check("a = 1\nparam a = 2\nx = a",
          "2:7: 'a' is already defined on line 1; choose another name");
}

TEST(Names, of_numbers_are_no_functions) {
    check("x(y+1)", "1:1: 'x' is not a function; write 'x*(…)'");
    check("pi(2)", "1:1: 'pi' is not a function; write 'pi*(…)'");
    check("a = 2\na(x)", "2:1: 'a' is not a function; write 'a*(…)'");
    check("param a = 2\na (x)", "2:1: 'a' is not a function; write 'a*(…)'");
    check("s = sphere(1)\ns(x)", "2:1: 's' is not a function");
    check("min = 3\nmin(x, y)",
          "2:1: 'min' is not a function here; line 1 gives the name another "
          "meaning, choose another one there");
    check("x(foo)", "1:1: 'x' is not a function; write 'x*(…)'\n1:3: unknown name 'foo'");
}

TEST(Names, of_functions_need_brackets) {
    check("sin + 1", "1:1: 'sin' needs its arguments in brackets; it is called 'sin(a)'");
    check("x = atan2", "1:5: 'atan2' needs its arguments in brackets; it is called 'atan2(y, x)'");
    check("sphere", "1:1: 'sphere' needs its arguments in brackets; it is called 'sphere(r = 1)'");
    check("union", "1:1: 'union' needs its arguments in brackets; it is called 'union(F, G, ...)'");
}

TEST(Names, that_are_built_in_have_their_values) {
    EXPECT_EQ(value_of("pi"), std::numbers::pi);
    EXPECT_EQ(value_of("e"), std::numbers::e);
    EXPECT_EQ(value_of("tau"), 2 * std::numbers::pi);
    EXPECT_EQ(value_of("t"), 0);
    EXPECT_EQ(value_at("r", {2, 3, 6}), 7);
    EXPECT_EQ(value_at("x + 10y + 100z", {1, 2, 3}), 321);
    EXPECT_EQ(value_of("2e"), 2 * std::numbers::e);
}

TEST(Names, that_are_never_used_are_warned_about) {
    EXPECT_EQ(report_of("a = 2\nparam b = 1\nc = 3\nx = c"),
              "formula:1:1: warning: the definition 'a' is never used\n"
              "a = 2\n"
              "^\n"
              "formula:2:7: warning: the parameter 'b' is never used\n"
              "param b = 1\n"
              "      ^\n");
}

}  // namespace
}  // namespace formula
