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
        if (parameter.name == name) return values[index(parameter.id)];
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
    document.parameters["c"] = 9;
    EXPECT_EQ(parameter_values(formula.field, document), (std::vector{0.0, 0.5, -2.0}));
}

}  // namespace
}  // namespace compile
