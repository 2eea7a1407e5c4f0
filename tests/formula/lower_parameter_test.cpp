// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <numbers>
#include <utility>
#include <vector>

#include "formula/understood.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view errors) {
    EXPECT_EQ(errors_of(text), errors) << "formula: " << text;
}

field::Parameter first_of(std::string_view text) {
    const base::Result<Lowered> result = understand(text);
    if (!result || result->field.parameters.empty()) {
        ADD_FAILURE() << report_of(text);
        return {};
    }
    return result->field.parameters.front();
}

std::pair<double, double> range_of(std::string_view text) {
    const field::Parameter it = first_of(text);
    return {it.minimum, it.maximum};
}

TEST(LowerParameter, keeps_all_that_is_declared) {
    const field::Parameter it =
        first_of("k = 2\nparam size = 0.5k in [-1, 2pi] step 0.1 \"Size of it\"\nx = size");
    EXPECT_EQ(it.name, "size");
    EXPECT_EQ(it.label, "Size of it");
    EXPECT_EQ(it.initial, std::vector{1.0});
    EXPECT_EQ(it.minimum, -1);
    EXPECT_EQ(it.maximum, 2 * std::numbers::pi);
    EXPECT_EQ(it.step, 0.1);
    EXPECT_EQ(it.span, (base::SourceSpan{12, 16}));
}

TEST(LowerParameter, has_its_name_as_label_and_no_step_by_default) {
    const field::Parameter it = first_of("param a = 0.5 in [0, 2]\nx = a");
    EXPECT_EQ(it.label, "a");
    EXPECT_EQ(it.step, std::nullopt);
}

TEST(LowerParameter, chooses_a_range_around_the_initial_value) {
    EXPECT_EQ(range_of("param a = 3\nx = a"), std::pair(0.0, 6.0));
    EXPECT_EQ(range_of("param a = -3\nx = a"), std::pair(-6.0, 0.0));
    EXPECT_EQ(range_of("param a = 0\nx = a"), std::pair(-1.0, 1.0));
    EXPECT_EQ(range_of("param a = 3 step 1\nx = a"), std::pair(0.0, 6.0));
    EXPECT_EQ(first_of("param a = 3 \"b\"\nx = a").label, "b");
}

TEST(LowerParameter, is_one_parameter_of_the_graph_in_the_order_of_the_text) {
    const auto result = understand("param b = 1\nparam a = 2\nx = a + 10b");
    ASSERT_TRUE(result);
    ASSERT_EQ(result->field.parameters.size(), 2u);
    EXPECT_EQ(result->field.parameters[0].name, "b");
    EXPECT_EQ(result->field.graph.name(result->field.parameters[0].ids[0]), "b");
    EXPECT_EQ(graph::index(result->field.parameters[0].ids[0]), 1u);
    EXPECT_EQ(graph::index(result->field.parameters[1].ids[0]), 2u);
    EXPECT_DOUBLE_EQ(value_at("param b = 1\nparam a = 2\nx = a + 10b", {20, 0, 0}), 8);
}

TEST(LowerParameter, must_have_sensible_values) {
    check("param a = 3 in [0, 2]\nx = a",
          "1:11: the initial value 3 of 'a' is outside its range [0, 2]");
    check("param a = 1 in [2, 0]\nx = a",
          "1:17: the range of 'a' is empty; write the smaller number first");
    check("param a = 1 in [1, 1]\nx = a",
          "1:17: the range of 'a' is empty; write the smaller number first");
    check("param a = 1 in [0, 2] step 0\nx = a", "1:28: the step of 'a' must be above 0");
    check("param a = 1 in [0, 2] step -1\nx = a", "1:28: the step of 'a' must be above 0");
    check("param a = 1/0\nx = a", "1:11: the initial value of 'a' is not a finite number");
    check("param a = 1 in [0, 1/0]\nx = a", "1:20: the maximum of 'a' is not a finite number");
    check("param a = 1 in [log(-1), 2]\nx = a", "1:17: the minimum of 'a' is not a finite number");
}

TEST(LowerParameter, has_constant_values) {
    const std::string end =
        " must be a constant; it cannot depend on the point, the time or another parameter";
    check("param a = x\nx = a", "1:11: the initial value of 'a'" + end);
    check("param a = t\nx = a", "1:11: the initial value of 'a'" + end);
    check("param a = 1\nparam b = 1 in [0, a]\nx = a + b", "2:20: the maximum of 'b'" + end);
    check("param a = sphere(1)\nx = a",
          "1:11: the initial value of 'a' must be a number or a vector, not a field");
    check("param a = 1 in [0, sphere(1)]\nx = a", "1:20: the maximum of 'a' must be one number");
    check("param a = 1 step sphere(1)\nx = a", "1:18: the step of 'a' must be one number");
    check("param a = foo\nx = a", "1:11: unknown name 'foo'");
}

TEST(LowerParameter, can_be_a_vector) {
    const field::Parameter c = first_of("param c = (1, -2, 3/2, 0.5)\njulia(c)");
    EXPECT_EQ(c.initial, (std::vector{1.0, -2.0, 1.5, 0.5}));
    EXPECT_EQ(c.ids.size(), 4u);
    EXPECT_EQ(std::pair(c.minimum, c.maximum), std::pair(-4.0, 4.0));
    EXPECT_EQ(first_of("param c = (1, 0, 3)\ntranslate(sphere(), c)").minimum, 0);
    EXPECT_EQ(first_of("param c = (-1, 0, 0)\ntranslate(sphere(), c)").maximum, 0);
    EXPECT_EQ(first_of("param c = (0, 0, 0)\ntranslate(sphere(), c)").maximum, 1);
}

TEST(LowerParameter, of_several_components_is_what_its_initial_value_is) {
    EXPECT_EQ(value_at("param c = (3, 5)\nx = c.x*c.y", {1, 0, 0}), -14);
    // i j = k, and i^2 = -1.
    const std::string text = "param q = quaternion(0, 1, 0, 0)\n";
    EXPECT_EQ(value_at(text + "x = (q*quaternion(0, 0, 1, 0)).w", {0, 0, 0}), -1);
    EXPECT_EQ(value_at(text + "x = (q*q).x", {0, 0, 0}), 1);
}

TEST(LowerParameter, of_several_components_has_one_range_for_all) {
    check("param c = (1, 3) in [0, 2]\njulia(c)",
          "1:11: component y of the initial value 3 of 'c' is outside its range [0, 2]");
    check("param c = (1, 1) in [(0, 0), 2]\njulia(c)",
          "1:22: the minimum of 'c' must be one number; it counts for every component");
    check("param c = (1, 2, 3, 4, 5)\njulia(c)", "1:11: a vector has at most four components");
}

TEST(LowerParameter, keeps_type_group_and_tooltip) {
    const field::Parameter it =
        first_of("param n = 3 integer group \"Sponge\" tooltip \"How deep.\"\nx = n");
    EXPECT_EQ(it.type, ParameterType::integer);
    EXPECT_EQ(it.group, "Sponge");
    EXPECT_EQ(it.tooltip, "How deep.");
    EXPECT_EQ(it.label, "n");
    EXPECT_EQ(first_of("param a = 1\nx = a").group, "");
}

TEST(LowerParameter, can_be_a_choice) {
    const std::string text = "param shape = \"square\" in [\"round\", \"square\"]\nx = shape";
    const field::Parameter it = first_of(text);
    EXPECT_EQ(it.type, ParameterType::choice);
    EXPECT_EQ(it.choices, (std::vector<std::string>{"round", "square"}));
    EXPECT_EQ(it.initial, std::vector{1.0});
    EXPECT_EQ(range_of(text), std::pair(0.0, 1.0));
    EXPECT_EQ(value_at(text, {5, 0, 0}), 4);
}

TEST(LowerParameter, can_be_on_or_off) {
    EXPECT_EQ(first_of("param cut = on\nx = cut").type, ParameterType::toggle);
    EXPECT_EQ(value_at("param cut = on\nx = cut", {5, 0, 0}), 4);
    EXPECT_EQ(value_at("param cut = off\nx = cut", {5, 0, 0}), 5);
    EXPECT_EQ(range_of("param cut = off\nx = cut"), std::pair(0.0, 1.0));
}

TEST(LowerParameter, of_a_type_has_a_range_that_suits_it) {
    const double pi = std::numbers::pi;
    EXPECT_EQ(range_of("param n = 3 integer\nx = n"), std::pair(0.0, 6.0));
    EXPECT_EQ(range_of("param a = 2 logarithmic\nx = a"), std::pair(0.2, 20.0));
    EXPECT_EQ(range_of("param a = 0.5 angle\nx = a"), std::pair(-pi, pi));
    EXPECT_EQ(range_of("param a = 2pi angle\nx = a"), std::pair(-2 * pi, 2 * pi));
    EXPECT_EQ(range_of("param a = -4 angle\nx = a"), std::pair(-2 * pi, 2 * pi));
    EXPECT_EQ(range_of("param a = (1, 0.5, 0) colour\ntranslate(sphere(), a)"),
              std::pair(0.0, 1.0));
    EXPECT_EQ(range_of("param a = (2, 0.5, 0) in [0, 4] colour\ntranslate(sphere(), a)"),
              std::pair(0.0, 4.0));
}

TEST(LowerParameter, of_type_integer_has_whole_values) {
    check("param n = 2.5 integer\nx = n",
          "1:11: the initial value 2.5 of the integer 'n' is not whole; write 3");
    check("param n = 2 in [0.5, 3.5] integer step 0.25\nx = n",
          "1:17: the minimum 0.5 of the integer 'n' is not whole; write 0\n"
          "1:22: the maximum 3.5 of the integer 'n' is not whole; write 4\n"
          "1:40: the step 0.25 of the integer 'n' is not whole; write 1");
}

TEST(LowerParameter, of_type_logarithmic_is_above_0) {
    check("param a = 1 in [0, 2] logarithmic\nx = a",
          "1:17: the minimum 0 of the logarithmic 'a' must be above 0; write for example 0.01");
    check("param a = 0 logarithmic\nx = a",
          "1:11: the initial value of the logarithmic 'a' must be above 0");
    check("param a = (1, -2, 1) logarithmic\ntranslate(sphere(), a)",
          "1:11: the initial value of the logarithmic 'a' must be above 0");
}

TEST(LowerParameter, of_type_colour_has_3_components) {
    const std::string end =
        "of the colour 'c' needs red, green and blue; write for example (1, 0.5, 0)";
    check("param c = 0.5 colour\nx = c", "1:11: the initial value " + end);
    check("param c = (1, 1, 1, 1) colour\njulia(c)", "1:11: the initial value " + end);
    check("param c = (1, 2, 1) colour\ntranslate(sphere(), c)",
          "1:11: component y of the initial value 2 of 'c' is outside its range [0, 1]");
}

TEST(LowerParameter, reports_all_bad_values) {
    check("param a = foo in [bar, 1] step 0\nx = a",
          "1:11: unknown name 'foo'\n"
          "1:19: unknown name 'bar'\n"
          "1:32: the step of 'a' must be above 0");
}

}  // namespace
}  // namespace formula
