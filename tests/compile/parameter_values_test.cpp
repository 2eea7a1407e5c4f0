// SPDX-License-Identifier: MIT
// Sliders of the formula against what the document says.
#include <gtest/gtest.h>

#include "compile/compile.h"
#include "compile/understood.h"

namespace compile {
namespace {

constexpr const char* text = "param a = 0.5 in [0, 1]\nparam b = -2 in [-3, 3]\na*x + b*y = t";

double value_of(const Formula& formula, const scene::Document& document, std::string_view name) {
    const std::vector<double> values = parameter_values(formula.field, document);
    for (const field::Parameter& parameter : formula.field.parameters) {
        if (parameter.name == name) return values[index(parameter.ids[0])];
    }
    ADD_FAILURE() << "no parameter " << name;
    return 0;
}

TEST(ParameterValues, are_the_defaults_unless_moved) {
    const Formula formula = understood(text);
    scene::Document document;
    EXPECT_EQ(value_of(formula, document, "a"), 0.5);
    EXPECT_EQ(value_of(formula, document, "b"), -2);
    document.parameters["b"] = 1.25;
    EXPECT_EQ(value_of(formula, document, "a"), 0.5);
    EXPECT_EQ(value_of(formula, document, "b"), 1.25);
}

TEST(ParameterValues, begin_with_the_time) {
    const Formula formula = understood(text);
    scene::Document document;
    document.time = 7;
    const std::vector<double> values = parameter_values(formula.field, document);
    ASSERT_EQ(values.size(), 3U);
    EXPECT_EQ(values[index(graph::parameter_t)], 7);
}

TEST(ParameterValues, ignore_names_that_the_formula_does_not_have) {
    const Formula formula = understood(text);
    scene::Document document;
    document.parameters["c"] = 9.0;
    EXPECT_EQ(parameter_values(formula.field, document), (std::vector{0.0, 0.5, -2.0}));
}

field::Parameter parameter(field::ParameterType type, std::vector<double> initial) {
    field::Parameter it;
    it.name = "p";
    it.type = type;
    it.initial = std::move(initial);
    return it;
}

field::Parameter shape() {
    field::Parameter it = parameter(field::ParameterType::choice, {0});
    it.choices = {"round", "square"};
    return it;
}

field::Parameter cut() { return parameter(field::ParameterType::toggle, {1}); }

std::string problem_of(const field::Parameter& parameter, const scene::ParameterValue& value) {
    const auto problems = components(parameter, value).problems();
    return problems.empty() ? "" : problems[0].message;
}

using Type = field::ParameterType;
using Components = std::vector<double>;

TEST(ParameterComponents, are_one_number_each) {
    EXPECT_EQ(*components(parameter(Type::real, {1}), 0.5), Components{0.5});
    EXPECT_EQ(*components(parameter(Type::real, {1, 2}), Components{3, 4}), (Components{3, 4}));
    EXPECT_EQ(*components(parameter(Type::colour, {1, 1, 1}), Components{0, 0.5, 1}),
              (Components{0, 0.5, 1}));
    EXPECT_EQ(*components(parameter(Type::real, {1}), 1e9), Components{1e9}) << "beyond its range";
}

TEST(ParameterComponents, of_an_integer_are_rounded) {
    EXPECT_EQ(*components(parameter(Type::integer, {1}), 2.6), Components{3});
    EXPECT_EQ(*components(parameter(Type::integer, {1, 1}), Components{-2.6, 2.4}),
              (Components{-3, 2}));
}

TEST(ParameterComponents, of_a_choice_are_the_index_of_the_label) {
    EXPECT_EQ(*components(shape(), "square"), Components{1});
    EXPECT_EQ(*components(shape(), 0.0), Components{0});
}

TEST(ParameterComponents, of_a_toggle_are_1_or_0) {
    EXPECT_EQ(*components(cut(), true), Components{1});
    EXPECT_EQ(*components(cut(), false), Components{0});
    EXPECT_EQ(*components(cut(), 1.0), Components{1});
}

TEST(ParameterComponents, must_suit_the_parameter) {
    const field::Parameter number = parameter(Type::real, {1});
    EXPECT_EQ(problem_of(number, true), "a number, not true");
    EXPECT_EQ(problem_of(number, "round"), "a number, not \"round\"");
    EXPECT_EQ(problem_of(number, Components{1, 2}), "a number, not a list of 2");
    const field::Parameter vector = parameter(Type::real, {1, 2, 3});
    EXPECT_EQ(problem_of(vector, 1.5), "a list of 3 numbers, not 1.5");
    EXPECT_EQ(problem_of(vector, Components{1, 2}), "a list of 3 numbers, not a list of 2");
    EXPECT_EQ(problem_of(shape(), "oval"), "one of \"round\", \"square\", not \"oval\"");
    EXPECT_EQ(problem_of(shape(), 2.0), "one of \"round\", \"square\", not 2");
    EXPECT_EQ(problem_of(shape(), 0.5), "one of \"round\", \"square\", not 0.5");
    EXPECT_EQ(problem_of(shape(), false), "one of \"round\", \"square\", not false");
    EXPECT_EQ(problem_of(cut(), "on"), "true or false, not \"on\"");
    EXPECT_EQ(problem_of(cut(), 2.0), "true or false, not 2");
}

TEST(ParameterComponents, go_into_the_document_as_people_write_them) {
    scene::Document document;
    const auto set = [&](const field::Parameter& it, const Components& value) {
        set_components(document, it, value);
        EXPECT_EQ(components_in(document, it), value);
        return document.parameters;
    };
    EXPECT_EQ(set(parameter(Type::real, {1}), {2}), (scene::ParameterValues{{"p", 2.0}}));
    EXPECT_EQ(set(parameter(Type::real, {1, 2}), {1, 3}),
              (scene::ParameterValues{{"p", Components{1, 3}}}));
    EXPECT_EQ(set(shape(), {1}), (scene::ParameterValues{{"p", "square"}}));
    EXPECT_EQ(set(cut(), {0}), (scene::ParameterValues{{"p", false}}));
    EXPECT_EQ(set(cut(), {1}), scene::ParameterValues{}) << "the default";
}

TEST(ParameterComponents, are_the_default_where_the_document_has_something_else) {
    scene::Document document;
    document.parameters["p"] = "round";
    EXPECT_EQ(components_in(document, parameter(Type::real, {1, 2})), (Components{1, 2}));
}

TEST(ParameterValues, of_vectors_are_one_a_component) {
    const Formula formula = understood("param a = 5\nparam c = (1, 2, 3, 4)\njulia(c) | x = a");
    scene::Document document;
    EXPECT_EQ(parameter_values(formula.field, document), (Components{0, 5, 1, 2, 3, 4}));
    EXPECT_EQ(formula.field.graph.name(formula.field.parameters[1].ids[2]), "c.z");
    document.parameters["c"] = Components{6, 7, 8, 9};
    EXPECT_EQ(parameter_values(formula.field, document), (Components{0, 5, 6, 7, 8, 9}));
}

TEST(CheckParameters, tells_what_does_not_suit_the_formula_and_where) {
    const Formula formula = understood("param a = 1\nparam level = 2\na*x = level");
    const scene::ParameterValues values{{"a", true}, {"level", 1.0}, {"lvel", 1.0}, {"z9", "x"}};
    const scene::ParameterPlaces places{{"a", {{5, 6}, {7, 8}}}, {"lvel", {{1, 2}, {3, 4}}}};
    const base::Diagnostics expected{
        base::Diagnostic{base::Severity::warning, "unknown parameter 'z9' is ignored", {}},
        base::warning({1, 2}, "unknown parameter 'lvel' is ignored; did you mean 'level'?"),
        base::error({7, 8}, "'parameters.a' must be a number, not true"),
    };
    EXPECT_EQ(check_parameters(formula.field, values, places), expected);
}

}  // namespace
}  // namespace compile
