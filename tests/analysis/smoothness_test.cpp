// SPDX-License-Identifier: MIT
// How smooth formulas are, held against what is known of them.
#include "analysis/smoothness.h"

#include <gtest/gtest.h>

#include "analysis/formulas.h"

namespace analysis {
namespace {

using graph::Expr;

template <class Build>
Regularity of(Build build, const Region& region = {}) {
    graph::Graph g;
    const auto at = [&](graph::VariableId id) { return Expr(g, g.variable(id)); };
    const Expr f = build(at(graph::variable_x), at(graph::variable_y), at(graph::variable_z));
    return regularity(g, f.id, region, std::array{0.0}, {.cells = 400, .depth = 24});
}

constexpr Regularity smooth{Smoothness::smooth, false};
constexpr Regularity kinks{Smoothness::piecewise, false};
constexpr Regularity jumps{Smoothness::discontinuous, false};
constexpr Regularity smooth_where_defined{Smoothness::smooth, true};
constexpr Regularity kinks_where_defined{Smoothness::piecewise, true};

TEST(Smoothness, of_polynomials_and_waves) {
    EXPECT_EQ(of(barth_sextic), smooth);
    EXPECT_EQ(of(gyroid), smooth);
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return exp(x) - 1.0; }), smooth);
}

TEST(Smoothness, sees_kinks) {
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return abs(x); }), kinks);
    EXPECT_EQ(of([](Expr x, Expr y, Expr z) { return hypot(x, y, z); }), kinks);
    EXPECT_EQ(of([](Expr x, Expr y, Expr) { return max(x, y); }), kinks);
    EXPECT_EQ(of([](Expr x, Expr y, Expr) { return sqrt(x * x + y * y); }), kinks);
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return pow(x * x, Expr(*x.graph, 0.75)); }), kinks);
}

TEST(Smoothness, of_what_stays_away_from_its_kinks_is_proven) {
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return sqrt(1.0 + x * x); }), smooth);
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return abs(x * x + 1.0); }), smooth);
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return max(x * x + 1.0, x); }), smooth);
    EXPECT_EQ(of([](Expr x, Expr y, Expr) { return hypot(x, y, Expr(*x.graph, 1)); }), smooth);
    // x^2 - x + 1 >= 3/4: the interval over all of the region does not show it, bisection does.
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return abs(x * x - x + 1.0); }), smooth);
    const Region aside{{5, 0, 0}, glm::dvec3(2), true};
    EXPECT_EQ(of([](Expr x, Expr y, Expr z) { return hypot(x, y, z); }, aside), smooth);
}

TEST(Smoothness, does_not_miss_a_kink_between_two_cells) {
    // The bisection of [-2, 2] cuts at 0, so that each side alone shows none.
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return abs(x); }).smoothness, Smoothness::piecewise);
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return max(x, -x); }).smoothness, Smoothness::piecewise);
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return sign(x); }).smoothness, Smoothness::discontinuous);
}

TEST(Smoothness, sees_jumps) {
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return floor(x); }), jumps);
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return sign(x); }), jumps);
    EXPECT_EQ(of([](Expr x, Expr y, Expr) { return atan2(y, x); }), jumps);
    EXPECT_EQ(of([](Expr x, Expr y, Expr) { return select_less(x, y, x, x + 1.0); }), jumps);
}

TEST(Smoothness, of_jumps_that_do_not_show) {
    // The floor is below -3 and never the larger one.
    EXPECT_EQ(of([](Expr x, Expr y, Expr) { return max(floor(x) - 9.0, y); }), smooth);
    const Region between{{0.5, 0, 0}, {0.4, 1, 1}, false};
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return floor(x); }, between), smooth);
    const Region right{{2, 0, 0}, glm::dvec3(1), true};
    EXPECT_EQ(of([](Expr x, Expr y, Expr) { return atan2(y, x); }, right), smooth);
    EXPECT_EQ(of([](Expr x, Expr, Expr) {
                  return select_less(x * x, Expr(*x.graph, 99), x, Expr(*x.graph, 1));
              }),
              smooth);
}

TEST(Smoothness, tells_poles_and_edges_apart_from_kinks) {
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return 1.0 / x; }), smooth_where_defined);
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return log(x); }), smooth_where_defined);
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return sqrt(x); }), kinks_where_defined);
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return 1.0 / (x * x + 1.0); }), smooth);
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return log(2.5 + x); }), smooth);
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return acos(x); }), kinks_where_defined);
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return acos(x * 0.25); }), smooth);
}

TEST(Smoothness, of_what_does_not_depend_on_the_point_is_smooth) {
    EXPECT_EQ(of([](Expr x, Expr, Expr) { return abs(Expr(*x.graph, 0)) + x; }), smooth);
}

}  // namespace
}  // namespace analysis
