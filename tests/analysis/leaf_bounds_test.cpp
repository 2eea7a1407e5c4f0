// SPDX-License-Identifier: MIT
// All bounds of a formula together, and the guess at its stiffness.
#include "analysis/leaf_bounds.h"

#include <gtest/gtest.h>

#include "analysis/counted_budget.h"
#include "analysis/formulas.h"
#include "analysis/heuristic_stiffness.h"

namespace analysis {
namespace {

using graph::Expr;
using numeric::infinity;

constexpr std::array no_parameters{0.0};

LeafBounds bounds_of(const Formula& f) { return leaf_bounds(tape_of(f), Region{}, no_parameters); }

TEST(LeafBounds, of_a_tame_surface_are_finite_and_not_stiff) {
    const LeafBounds bounds = bounds_of(Formula(barth_sextic));
    EXPECT_LT(bounds.lipschitz, 1200);
    EXPECT_LT(bounds.second_derivative, 3000);
    EXPECT_FALSE(bounds.partial);
    EXPECT_FALSE(bounds.stiff);
}

TEST(LeafBounds, without_any_bound_are_stiff) {
    const LeafBounds bounds = bounds_of(Formula([](Expr x, Expr, Expr) { return 1.0 / x; }));
    EXPECT_EQ(bounds.lipschitz, infinity);
    EXPECT_EQ(bounds.second_derivative, infinity);
    EXPECT_TRUE(bounds.partial);
    EXPECT_TRUE(bounds.stiff);
}

TEST(LeafBounds, of_one_steep_place_far_from_the_rest_are_stiff) {
    const LeafBounds bounds =
        bounds_of(Formula([](Expr x, Expr y, Expr) { return exp(20.0 * x) + y; }));
    EXPECT_LT(bounds.lipschitz, infinity);
    EXPECT_TRUE(bounds.stiff);
}

TEST(LeafBounds, are_larger_when_time_runs_out) {
    const Formula f(barth_sextic);
    const LeafBounds fine = bounds_of(f);
    LeafBounds last{.lipschitz = infinity, .second_derivative = infinity};
    for (const int questions : {0, 1, 10, 100, 100'000}) {
        const Budget budget = over_after(questions);
        const LeafBounds some =
            leaf_bounds(tape_of(f), Region{}, no_parameters, {.budget = &budget});
        EXPECT_EQ(budget.was_over(), questions < 100'000);
        EXPECT_GE(some.lipschitz, fine.lipschitz);
        EXPECT_GE(some.second_derivative, fine.second_derivative);
        EXPECT_LE(some.lipschitz, last.lipschitz);
        EXPECT_LE(some.second_derivative, last.second_derivative);
        EXPECT_LT(some.second_derivative, infinity);
        last = some;
    }
    EXPECT_EQ(last.second_derivative, fine.second_derivative);
}

TEST(HeuristicStiffness, counts_the_steps_through_a_distance_field) {
    // |r - 2| has the median 2 (1 - (1/2)^(1/3)) over the ball of radius 2.
    const Formula f([](Expr x, Expr y, Expr z) { return hypot(x, y, z) - 2.0; });
    const eval::Tape tape = tape_of(f);
    const double steps = heuristic_steps(tape, Region{}, no_parameters, 1, infinity);
    EXPECT_NEAR(steps, 4 / (2 * (1 - std::cbrt(0.5))), 0.3);
    EXPECT_NEAR(heuristic_steps(tape, Region{}, no_parameters, 10, infinity), 10 * steps, 1e-9);
    EXPECT_EQ(heuristic_steps(tape, Region{}, no_parameters, infinity, infinity), infinity);
}

TEST(HeuristicStiffness, takes_the_better_of_both_bounds) {
    const Formula f([](Expr x, Expr, Expr) { return 0.0 * x + 8.0; });
    const eval::Tape tape = tape_of(f);
    // Steps of 8 / 16 and sqrt(16 / 1).
    EXPECT_NEAR(heuristic_steps(tape, Region{}, no_parameters, 16, infinity), 8, 1e-12);
    EXPECT_NEAR(heuristic_steps(tape, Region{}, no_parameters, 16, 1), 1, 1e-12);
}

}  // namespace
}  // namespace analysis
