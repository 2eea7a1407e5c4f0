// SPDX-License-Identifier: MIT
#include "analysis/uniform_curvature.h"

#include <gtest/gtest.h>

#include "analysis/formulas.h"

namespace analysis {
namespace {

using graph::Expr;

template <class Build>
bool uniform(Build build) {
    const Formula f(build);
    return has_uniform_curvature(f.graph, f.value);
}

TEST(UniformCurvature, is_that_of_low_degrees_and_of_waves) {
    EXPECT_TRUE(uniform(torus));
    EXPECT_TRUE(uniform(gyroid));
    EXPECT_TRUE(uniform([](Expr x, Expr y, Expr) { return sin(2.0 * x + y) - 0.5 * y; }));
}

TEST(UniformCurvature, is_not_that_of_what_grows_or_has_poles) {
    EXPECT_FALSE(uniform(barth_sextic));
    EXPECT_FALSE(uniform([](Expr x, Expr y, Expr) { return x * sin(y); }));
    EXPECT_FALSE(uniform([](Expr x, Expr y, Expr) { return sin(x * y); }));
    EXPECT_FALSE(uniform([](Expr x, Expr y, Expr) { return y - 1.0 / x; }));
    EXPECT_FALSE(uniform([](Expr x, Expr y, Expr z) { return hypot(x, y, z) - sin(x); }));
}

}  // namespace
}  // namespace analysis
