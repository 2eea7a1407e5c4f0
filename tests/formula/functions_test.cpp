// SPDX-License-Identifier: MIT
#include "formula/functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "formula/understood.h"

namespace formula {
namespace {

void check(const std::string& text, double value) {
    EXPECT_DOUBLE_EQ(value_of(text), value) << "formula: " << text;
}

TEST(Functions, are_sorted_by_name) {
    EXPECT_TRUE(std::ranges::is_sorted(functions(), {}, &Function::name));
}

TEST(Functions, of_one_argument_have_their_usual_values) {
    check("sin(0.7)", std::sin(0.7));
    check("cos(0.7)", std::cos(0.7));
    check("tan(0.7)", std::tan(0.7));
    check("asin(0.7)", std::asin(0.7));
    check("acos(0.7)", std::acos(0.7));
    check("atan(0.7)", std::atan(0.7));
    check("sinh(0.7)", std::sinh(0.7));
    check("cosh(0.7)", std::cosh(0.7));
    check("tanh(0.7)", std::tanh(0.7));
    check("exp(0.7)", std::exp(0.7));
    check("log(0.7)", std::log(0.7));
    check("sqrt(0.7)", std::sqrt(0.7));
    check("cbrt(-8)", -2);
    check("abs(-3)", 3);
    check("sign(-3)", -1);
    check("sign(0)", 0);
    check("floor(-0.5)", -1);
    check("ceil(0.5)", 1);
}

TEST(Functions, of_more_arguments_take_them_in_the_documented_order) {
    check("atan2(1, -1)", 3 * std::atan(1.0));
    check("pow(2, 10)", 1024);
    check("hypot(3, 4)", 5);
    check("hypot(2, 3, 6)", 7);
    check("min(3, 1)", 1);
    check("min(3, 1, 2, 0.5)", 0.5);
    check("max(3, 1)", 3);
    check("max(3, 1, 7, 5)", 7);
}

TEST(Functions, without_an_operator_are_composed_as_defined) {
    check("mod(5.5, 2)", 1.5);
    check("mod(-0.5, 2)", 1.5);
    check("mod(5, -3)", -1);
    check("clamp(5, 0, 2)", 2);
    check("clamp(-5, 0, 2)", 0);
    check("clamp(1, 0, 2)", 1);
    check("mix(2, 6, 0.25)", 3);
    check("mix(2, 6, 2)", 10);
    check("step(1, 0.5)", 0);
    check("step(1, 1)", 1);
    check("step(1, 2)", 1);
    check("smoothstep(1, 3, 0)", 0);
    check("smoothstep(1, 3, 1.5)", 0.15625);
    check("smoothstep(1, 3, 2)", 0.5);
    check("smoothstep(1, 3, 9)", 1);
}

TEST(Functions, have_arithmetic_around_them) {
    check("2^3^2", 512);
    check("-2^2", -4);
    check("2^-1", 0.5);
    check("(-2)^3", -8);
    check("1/2*4", 2);
    check("2 - 3 - 4", -5);
    check("8/4/2", 1);
    check("2(3 + 1)(5)", 40);
    check("1/2(3)", 1.5);
    EXPECT_DOUBLE_EQ(value_at("1/2x", {3, 0, 0}), 1.5);
    EXPECT_DOUBLE_EQ(value_at("sin(2x)cos(y)", {0.3, 0.4, 0}), std::sin(0.6) * std::cos(0.4));
}

TEST(Functions, report_a_wrong_number_of_arguments_with_their_signature) {
    EXPECT_EQ(errors_of("sin()"), "1:1: 'sin' takes 1 argument, not 0; write 'sin(a)'");
    EXPECT_EQ(errors_of("sin(x, y)"), "1:1: 'sin' takes 1 argument, not 2; write 'sin(a)'");
    EXPECT_EQ(errors_of("2atan2(x)"), "1:2: 'atan2' takes 2 arguments, not 1; write 'atan2(y, x)'");
    EXPECT_EQ(errors_of("min(x)"),
              "1:1: 'min' takes 2 or more arguments, not 1; write 'min(a, b, ...)'");
    EXPECT_EQ(errors_of("hypot(x)"),
              "1:1: 'hypot' takes 2 or 3 arguments, not 1; write 'hypot(a, b) "
              "or hypot(a, b, c)'");
}

TEST(Functions, take_numbers_only) {
    EXPECT_EQ(errors_of("sin(sphere(1))"),
              "1:5: a field cannot be used as an argument of 'sin'; join fields with '|', '&' or "
              "'\\'");
    EXPECT_EQ(errors_of("max((1, 2), 3)"),
              "1:1: a vector of 2 is no field; write an equation or a field");
    EXPECT_EQ(
        errors_of("abs(x = 1)"),
        "1:5: a comparison cannot be used as an argument of 'abs'; join fields with '|', '&' or "
        "'\\'");
}

}  // namespace
}  // namespace formula
