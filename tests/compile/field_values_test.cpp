// SPDX-License-Identifier: MIT
// The numbers that a program is fed with.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/leaf_bounds.h"
#include "compile/compile.h"
#include "compile/understood.h"

namespace compile {
namespace {

using shader::FieldValue;

struct Frame {
    Formula formula;
    scene::Document document;
    shader::ProgramSource source;

    explicit Frame(std::string_view text)
        : formula(understood(text)),
          source(shader::program_source(formula.field, by_region(formula, document))) {}

    /// Bounds of the whole region, also for formulas that are known brick by brick.
    static shader::Features by_region(const Formula& formula, const scene::Document& document) {
        shader::Features features = compile::features(formula, document, {});
        features.bricks.clear();
        return features;
    }

    std::vector<double> values() const { return field_numbers(formula, source, document).values; }
    /// The value of this kind of the first leaf that has one.
    float value(FieldValue::What what) const {
        const auto found = std::ranges::find(source.field_values, what, &FieldValue::what);
        if (found == source.field_values.end()) return NAN;
        return values()[static_cast<std::size_t>(found - source.field_values.begin())];
    }
    float inverse_lipschitz() const { return value(FieldValue::What::inverse_lipschitz); }
    float second_derivative() const { return value(FieldValue::What::second_derivative); }
    float first_order() const { return value(FieldValue::What::first_order); }

    analysis::LeafBounds bounds() const {
        const scene::Bounds region = scene::framed_region(document.bounds);
        return analysis::leaf_bounds(
            formula.tapes.formulas.begin()->second,
            {region.centre, region.half, region.shape == scene::Bounds::Shape::sphere},
            parameter_values(formula.field, document));
    }
};

TEST(FieldValues, are_as_many_as_the_program_lists) {
    for (const char* text : {"sphere(1)", "x*y = z", "(x <= y^2) | (y <= sin(z))",
                             "param n = 2 in [1, 4]\nmenger(n) | (x*y <= z)"}) {
        const Frame frame(text);
        EXPECT_EQ(frame.values().size(), frame.source.field_values.size()) << text;
    }
}

TEST(FieldValues, hold_expressions_of_parameters_computed_in_double) {
    Frame frame("param a = 3 in [0, 9]\nx*(sin(a) + a^2) + y = t");
    // The first expression in the program's order that is no parameter itself.
    const auto contains = [&](double expected) {
        const std::vector<double> values = frame.values();
        return std::ranges::count(values, expected) > 0;
    };
    EXPECT_TRUE(contains(std::sin(3.0) + 9));
    frame.document.parameters["a"] = 2.0;
    EXPECT_TRUE(contains(std::sin(2.0) + 4));
    EXPECT_FALSE(contains(std::sin(3.0) + 9));
    frame.document.time = 123.25;
    EXPECT_TRUE(contains(123.25));
}

TEST(FieldValues, hold_the_limit_of_an_iteration) {
    Frame frame("menger(3)");
    EXPECT_EQ(frame.values()[0], 3);
}

TEST(FieldValues, round_bounds_to_the_safe_side) {
    for (const char* text : {"x^2 + y^2 + z^2 = 1", "sin(3x) + sin(y)*z = 0.1", "x/3 + y/7 = z/11",
                             "x^3*y - z^2*sin(x) = 1", "exp(x) + y = 0"}) {
        const Frame frame(text);
        const analysis::LeafBounds bounds = frame.bounds();
        ASSERT_FALSE(bounds.partial) << text;
        ASSERT_TRUE(std::isfinite(bounds.lipschitz)) << text;
        EXPECT_LE(static_cast<double>(frame.inverse_lipschitz()), 1 / bounds.lipschitz) << text;
        EXPECT_GE(frame.inverse_lipschitz() * 1.000001, 1 / bounds.lipschitz) << text;
        EXPECT_GE(static_cast<double>(frame.second_derivative()), bounds.second_derivative) << text;
        EXPECT_LE(frame.second_derivative(), bounds.second_derivative * 1.000001 + 1e-30) << text;
    }
}

TEST(FieldValues, bound_what_is_known_exactly) {
    // Over the ball of radius 2 the gradient of x^2 + y^2 + z^2 - 1 is at most 4 long.
    const Frame frame("x^2 + y^2 + z^2 = 1");
    EXPECT_LE(frame.inverse_lipschitz(), 0.25F);
    EXPECT_GT(frame.inverse_lipschitz(), 0.2F);
    EXPECT_GE(frame.second_derivative(), 2.0F);
    EXPECT_LT(frame.second_derivative(), 2.1F);
    EXPECT_EQ(frame.first_order(), 0);
}

TEST(FieldValues, follow_the_bounds_of_the_document) {
    Frame frame("x^2 + y^2 + z^2 = 1");
    frame.document.bounds.half = glm::dvec3(20);
    EXPECT_LE(frame.inverse_lipschitz(), 1.0F / 40);
    frame.document.bounds.half = glm::dvec3(0.5);
    EXPECT_GT(frame.inverse_lipschitz(), 0.5F);
}

TEST(FieldValues, follow_the_parameters) {
    Frame frame("param a = 1 in [0, 9]\na*x = y");
    const float before = frame.inverse_lipschitz();
    frame.document.parameters["a"] = 8.0;
    EXPECT_LT(frame.inverse_lipschitz(), before / 4);
}

TEST(FieldValues, say_where_nothing_is_known) {
    const Frame pole("1/x = y");
    EXPECT_EQ(pole.inverse_lipschitz(), 0);
    EXPECT_LT(pole.second_derivative(), 0);
    EXPECT_EQ(pole.first_order(), 1);
    const Frame kink("abs(x) = y");
    EXPECT_GT(kink.inverse_lipschitz(), 0);
    EXPECT_LT(kink.second_derivative(), 0) << "no second derivative across a kink";
}

TEST(FieldValues, promise_nothing_without_bounds) {
    Frame frame("x^2 + y^2 + z^2 = 1");
    frame.document.bounds.shape = scene::Bounds::Shape::none;
    EXPECT_EQ(frame.inverse_lipschitz(), 0);
    EXPECT_LT(frame.second_derivative(), 0);
    EXPECT_EQ(frame.first_order(), 1);
}

TEST(FieldValues, let_rays_go_far_in_a_formula_without_roots) {
    EXPECT_GE(Frame("0*t = 1").inverse_lipschitz(), 1e20F);
}

TEST(FieldValues, are_the_same_every_time) {
    const Frame a("param n = 2 in [1, 4]\nmenger(n) | (x*y <= sin(z))");
    const Frame b("param n = 2 in [1, 4]\nmenger(n) | (x*y <= sin(z))");
    EXPECT_EQ(a.values(), b.values());
}

}  // namespace
}  // namespace compile
