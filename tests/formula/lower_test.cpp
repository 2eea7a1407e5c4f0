// SPDX-License-Identifier: MIT
#include "formula/lower.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>

#include "formula/understood.h"

namespace formula {
namespace {

field::Formula root_of(std::string_view text) {
    const base::Result<Lowered> result = understand(text);
    if (!result) {
        ADD_FAILURE() << report_of(text);
        return {};
    }
    const auto* formula = std::get_if<field::Formula>(&result->field[result->field.root]);
    EXPECT_TRUE(formula) << text;
    return formula ? *formula : field::Formula{};
}

TEST(Lower, an_equation_is_a_sheet_of_the_difference) {
    EXPECT_EQ(root_of("x = 2y").kind, field::Kind::sheet);
    EXPECT_EQ(root_of("x = 2y").metric, field::Metric::scalar);
    EXPECT_DOUBLE_EQ(value_at("x = 2y", {5, 1, 0}), 3);
    EXPECT_DOUBLE_EQ(value_at("x^2 + y^2 + z^2 = 1", {1, 2, 2}), 8);
}

TEST(Lower, an_inequality_is_a_solid_that_is_negative_inside) {
    for (const char* text : {"x <= 2", "x < 2", "2 >= x", "2 > x"}) {
        EXPECT_EQ(root_of(text).kind, field::Kind::solid) << text;
        EXPECT_DOUBLE_EQ(value_at(text, {5, 0, 0}), 3) << text;
        EXPECT_DOUBLE_EQ(value_at(text, {1, 0, 0}), -1) << text;
    }
}

TEST(Lower, a_bare_number_is_the_sheet_where_it_is_zero) {
    EXPECT_EQ(root_of("x - 2").kind, field::Kind::sheet);
    EXPECT_DOUBLE_EQ(value_at("x - 2", {5, 0, 0}), 3);
}

TEST(Lower, comparing_with_zero_adds_nothing) {
    const auto plain = understand("x*y");
    const auto compared = understand("x*y = 0");
    ASSERT_TRUE(plain && compared);
    const auto& f = std::get<field::Formula>(compared->field[compared->field.root]);
    EXPECT_EQ(compared->field.graph[f.value].op, graph::Op::mul);
}

TEST(Lower, equal_expressions_are_one_node) {
    const auto result = understand("a = sin(x)\nb = sin(x)\na*b = 1");
    ASSERT_TRUE(result);
    const auto& f = std::get<field::Formula>(result->field[result->field.root]);
    const graph::Node& sub = result->field.graph[f.value];
    const graph::Node& product = result->field.graph[sub.arguments[0]];
    EXPECT_EQ(product.arguments[0], product.arguments[1]);
}

TEST(Lower, definitions_hold_numbers_tuples_and_fields) {
    EXPECT_DOUBLE_EQ(value_at("a = 2x\nb = a + 1\nb <= 0", {1, 0, 0}), 3);
    EXPECT_DOUBLE_EQ(value_at("half = z <= 0\nball = sphere(1)\nball \\ half", {0, 0, 0.5}), -0.5);
    EXPECT_DOUBLE_EQ(value_at("d = (1, 2, 3)\ntranslate(sphere(1), d)", {1, 2, 3}), -1);
}

TEST(Lower, fields_stand_nowhere_in_arithmetic) {
    EXPECT_EQ(errors_of("sphere(1) + 1"),
              "1:1: a field cannot be used in arithmetic; join fields with '|', '&' or '\\'");
    EXPECT_EQ(errors_of("2sphere(1)"),
              "1:2: a field cannot be used in arithmetic; join fields with '|', '&' or '\\'");
    EXPECT_EQ(errors_of("-(x = 1)"),
              "1:2: a comparison cannot be used in arithmetic; join fields with '|', '&' or '\\'");
    EXPECT_EQ(errors_of("(x <= 1)^2"),
              "1:1: a comparison cannot be used in arithmetic; join fields with '|', '&' or '\\'");
    EXPECT_EQ(errors_of("sphere(1) <= 0"),
              "1:1: a field cannot be used in a comparison; join fields with '|', '&' or '\\'");
    EXPECT_EQ(errors_of("julia() = 0"),
              "1:1: a field cannot be used in a comparison; join fields with '|', '&' or '\\'");
    EXPECT_EQ(
        errors_of("(x = 1) <= sphere(1)"),
        "1:1: a comparison cannot be used in a comparison; join fields with '|', '&' or '\\'\n"
        "1:12: a field cannot be used in a comparison; join fields with '|', '&' or '\\'");
    EXPECT_EQ(errors_of("(1, 2) = x"),
              "1:1: a vector of 2 cannot be used in a comparison; take its length(…) or a "
              "component such as .x");
}

TEST(Lower, an_equation_of_a_solid_is_its_surface_with_a_warning) {
    EXPECT_EQ(report_of("sphere(1) = 0"),
              "formula:1:1: warning: an equation makes a sheet of this solid: its surface alone, "
              "without an inside; leave the equation away for the solid\n"
              "sphere(1) = 0\n"
              "^~~~~~~~~\n");
    EXPECT_EQ(root_of("sphere(1) = 0").kind, field::Kind::sheet);
    EXPECT_DOUBLE_EQ(value_at("sphere(1) = 0.5", {2, 0, 0}), 0.5);
    EXPECT_DOUBLE_EQ(value_at("ball = sphere(1)\n0 = ball", {3, 0, 0}), -2);
}

TEST(Lower, depends_on_no_locale) {
    const char* old = std::setlocale(LC_ALL, nullptr);
    const std::string saved = old ? old : "C";
    if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) GTEST_SKIP() << "no locale with a decimal comma";
    EXPECT_EQ(value_of("1.5 + .25"), 1.75);
    EXPECT_EQ(errors_of("param a = 2.5 in [0, 1.5]\nx = a"),
              "1:11: the initial value 2.5 of 'a' is outside its range [0, 1.5]");
    std::setlocale(LC_ALL, saved.c_str());
}

}  // namespace
}  // namespace formula
