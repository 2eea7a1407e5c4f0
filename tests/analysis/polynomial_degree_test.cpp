// SPDX-License-Identifier: MIT
// Degrees of polynomials, and what is none.
#include "analysis/polynomial_degree.h"

#include <gtest/gtest.h>

#include "analysis/formulas.h"

namespace analysis {
namespace {

using graph::Expr;

std::optional<int> degree(const Formula& f) { return polynomial_degree(f.graph, f.value); }

/// The degree without any passes, as the passes rewrite much of what is tested here.
template <class Build>
std::optional<int> raw_degree(Build build) {
    graph::Graph g;
    const Expr x(g, g.variable(graph::variable_x)), y(g, g.variable(graph::variable_y));
    const Expr p(g, g.parameter(g.new_parameter("p")));
    return polynomial_degree(g, build(x, y, p).id);
}

TEST(PolynomialDegree, of_known_surfaces) {
    EXPECT_EQ(degree(Formula(barth_sextic)), 6);
    EXPECT_EQ(degree(Formula(torus)), 4);
    EXPECT_EQ(degree(Formula(gyroid)), std::nullopt);
}

TEST(PolynomialDegree, follows_sums_products_and_powers) {
    EXPECT_EQ(raw_degree([](Expr x, Expr y, Expr) { return x * x * y + y; }), 3);
    EXPECT_EQ(raw_degree([](Expr x, Expr y, Expr) { return -(x - y); }), 1);
    EXPECT_EQ(raw_degree([](Expr x, Expr, Expr) { return pow(x * x, Expr(*x.graph, 5)); }), 10);
    EXPECT_EQ(raw_degree([](Expr x, Expr, Expr) { return pow(x, Expr(*x.graph, 0)); }), 0);
    EXPECT_EQ(raw_degree([](Expr x, Expr, Expr) { return Expr(*x.graph, 7); }), 0);
}

TEST(PolynomialDegree, lets_coefficients_be_anything) {
    EXPECT_EQ(raw_degree([](Expr x, Expr, Expr p) { return sin(p) * x * x / sqrt(p); }), 2);
    EXPECT_EQ(raw_degree([](Expr, Expr, Expr p) { return floor(p); }), 0);
}

TEST(PolynomialDegree, is_none_for_what_is_no_polynomial) {
    EXPECT_EQ(raw_degree([](Expr x, Expr, Expr) { return 1.0 / x; }), std::nullopt);
    EXPECT_EQ(raw_degree([](Expr x, Expr, Expr p) { return pow(x, p); }), std::nullopt);
    EXPECT_EQ(raw_degree([](Expr x, Expr, Expr) { return pow(x, Expr(*x.graph, 0.5)); }),
              std::nullopt);
    EXPECT_EQ(raw_degree([](Expr x, Expr, Expr) { return pow(x, Expr(*x.graph, -1)); }),
              std::nullopt);
    EXPECT_EQ(raw_degree([](Expr x, Expr y, Expr) { return max(x, y); }), std::nullopt);
    EXPECT_EQ(raw_degree([](Expr x, Expr, Expr) { return 0.0 * abs(x) + 1.0; }), std::nullopt);
}

TEST(PolynomialDegree, stops_counting_where_squares_of_squares_would_overflow) {
    EXPECT_EQ(raw_degree([](Expr x, Expr, Expr) {
                  for (int i = 0; i < 100; ++i) x = x * x;
                  return x;
              }),
              std::nullopt);
}

TEST(PolynomialDegree, counts_the_chosen_variables_only) {
    // The step of a Julia set: quadratic in its state, linear in the point.
    graph::Graph g;
    const graph::VariableId a = g.new_variable("a"), b = g.new_variable("b");
    const Expr x(g, g.variable(graph::variable_x)), za(g, g.variable(a)), zb(g, g.variable(b));
    const std::array step{(za * za - zb * zb + x).id, (2.0 * za * zb + sin(x)).id};
    EXPECT_EQ(polynomial_degree(g, step, std::array{a, b}), 2);
    EXPECT_EQ(polynomial_degree(g, step, std::array{a}), 2);
    EXPECT_EQ(polynomial_degree(g, step, std::array{b}), 2);
    EXPECT_EQ(polynomial_degree(g, std::array{step[1]}, std::array{b}), 1);
    EXPECT_EQ(polynomial_degree(g, std::array{step[0]}, std::array{graph::variable_x}), 1);
    EXPECT_EQ(polynomial_degree(g, step, std::array{graph::variable_x}), std::nullopt);
}

}  // namespace
}  // namespace analysis
