// SPDX-License-Identifier: MIT
#include "analysis/smoothness.h"

#include <gtest/gtest.h>

#include "analysis/formulas.h"

namespace analysis {
namespace {

using graph::Expr;

template <class Build>
Smoothness of(Build build) {
    const Formula f(build);
    return smoothness(f.graph, f.value);
}

TEST(Smoothness, is_that_of_the_worst_operator) {
    EXPECT_EQ(of(barth_sextic), Smoothness::smooth);
    EXPECT_EQ(of([](Expr x, Expr y, Expr) { return 1.0 / x + sqrt(y); }), Smoothness::smooth);
    EXPECT_EQ(of([](Expr x, Expr y, Expr) { return x + abs(y); }), Smoothness::piecewise);
    EXPECT_EQ(of([](Expr x, Expr y, Expr) { return abs(x) + floor(y); }),
              Smoothness::discontinuous);
    EXPECT_EQ(of([](Expr x, Expr y, Expr) { return atan2(y, x); }), Smoothness::discontinuous);
}

TEST(Smoothness, of_the_derivative_of_a_kink_is_a_jump) {
    Formula f([](Expr x, Expr y, Expr) { return min(x * x, y); });
    EXPECT_EQ(smoothness(f.graph, f.value), Smoothness::piecewise);
    Expr a(f.graph, f.graph.variable(graph::variable_x));
    Expr b(f.graph, f.graph.variable(graph::variable_y));
    EXPECT_EQ(smoothness(f.graph, select_less(a, b, a, b).id), Smoothness::discontinuous);
}

TEST(Smoothness, counts_only_what_depends_on_the_point) {
    EXPECT_EQ(of([](Expr x, Expr, Expr) {
                  return x * floor(Expr(*x.graph, x.graph->parameter(graph::parameter_t)));
              }),
              Smoothness::smooth);
}

}  // namespace
}  // namespace analysis
