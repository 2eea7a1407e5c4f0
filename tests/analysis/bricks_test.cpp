// SPDX-License-Identifier: MIT
// What is proven of bricks, held against values at points; no false proof for any scene.
#include "analysis/bricks.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "analysis/counted_budget.h"
#include "analysis/random_scene.h"
#include "eval/field_value.h"
#include "field/shapes.h"

namespace analysis {
namespace {

constexpr Region ball{};  // of radius 2
constexpr Region cube{glm::dvec3(0.25), glm::dvec3(2, 1, 1.5), false};

/// A point of the brick, the same for the same number.
glm::dvec3 point_in(const BrickGrid& grid, glm::ivec3 at, unsigned number) {
    const Cell cell = grid.widened(at);
    return spread_point({cell.middle(), 0.5 * (cell.high - cell.low), false}, number);
}

/// Values at points of decided bricks: of solids none is on the other side, of sheets none is 0.
void expect_no_false_proof(const RandomScene& scene, const Bricks& found, const Region& region) {
    for (std::size_t i = 0; i < found.bricks.size(); ++i) {
        if (found.bricks[i] == Brick::surface) continue;
        for (unsigned k = 0; k < 4; ++k) {
            const glm::dvec3 p = point_in(found.grid, found.grid.at(i), k);
            if (!contains(region, p)) continue;
            const double value = eval::value(scene.field, scene.field.root, p, scene.parameters);
            if (kind_of(scene.field, scene.field.root) == field::Kind::sheet) {
                ASSERT_NE(value, 0) << i;
            } else {
                ASSERT_EQ(value <= 0, found.bricks[i] == Brick::inside) << i << ": " << value;
            }
        }
    }
}

TEST(Bricks, of_a_ball_are_undecided_at_its_surface_only) {
    const field::Field ball_of_1 = field::primitive("sphere", {1});
    const Bricks found = bricks(ball_of_1, ball_of_1.root, {}, ball, {.side = 16});
    ASSERT_EQ(found.grid.side, 16);
    const double diagonal = glm::length(found.grid.size());
    for (std::size_t i = 0; i < found.bricks.size(); ++i) {
        const Cell cell = found.grid.widened(found.grid.at(i));
        const double radius = glm::length(cell.middle());
        const double half = 0.5 * glm::length(cell.high - cell.low);
        if (radius - half > 1) {
            EXPECT_EQ(found.bricks[i], Brick::outside) << i;
        }
        if (radius + half < 1) {
            EXPECT_EQ(found.bricks[i], Brick::inside) << i;
        }
        if (found.bricks[i] != Brick::surface) {
            EXPECT_GT(std::abs(radius - 1), 0.2 * diagonal);
        }
    }
}

TEST(Bricks, never_say_too_much_of_random_scenes) {
    constexpr unsigned seed = 20160417;
    eval::Random random(seed);
    std::size_t decided = 0, all = 0;
    for (int i = 0; i < 300; ++i) {
        const RandomScene scene(random, i % 3 == 0);
        const Region& region = i % 2 == 0 ? ball : cube;
        const Bricks found =
            bricks(scene.field, scene.field.root, scene.parameters, region, {.side = 8});
        SCOPED_TRACE("scene " + std::to_string(i) + ", seed " + std::to_string(seed));
        expect_no_false_proof(scene, found, region);
        if (HasFatalFailure()) return;
        decided += found.decided();
        all += found.bricks.size();
    }
    EXPECT_GT(decided, all / 2);
}

/// Between two points of a brick without a surface no continuous sheet changes its sign.
TEST(Bricks, hold_no_change_of_sign_of_a_gyroid) {
    field::Field field;
    const auto at = [&](graph::VariableId id) {
        return graph::Expr(field.graph, field.graph.variable(id));
    };
    const graph::Expr x = 3.0 * at(graph::variable_x), y = 3.0 * at(graph::variable_y),
                      z = 3.0 * at(graph::variable_z);
    const graph::Expr f = sin(x) * cos(y) + sin(y) * cos(z) + sin(z) * cos(x);
    field.root = field.add(field::Formula{f.id, field::Metric::scalar, field::Kind::sheet});
    const Bricks found = bricks(field, field.root, {}, cube, {.side = 16});
    EXPECT_GT(found.decided(), found.bricks.size() / 8);
    for (std::size_t i = 0; i < found.bricks.size(); ++i) {
        if (found.bricks[i] == Brick::surface) continue;
        int positive = 0;
        for (unsigned k = 0; k < 16; ++k) {
            const glm::dvec3 p = point_in(found.grid, found.grid.at(i), k);
            positive += eval::value(field, field.root, p, {}) > 0;
        }
        EXPECT_EQ(positive % 16, 0) << i;
    }
}

TEST(Bricks, are_the_same_on_any_number_of_threads) {
    eval::Random random(271828);
    for (int i = 0; i < 20; ++i) {
        const RandomScene scene(random, i % 2 == 0);
        const auto found = [&](int threads) {
            return bricks(scene.field, scene.field.root, scene.parameters, ball,
                          {.side = 16, .threads = threads});
        };
        const Bricks one = found(1);
        for (const int threads : {2, 5}) {
            EXPECT_EQ(found(threads).bricks, one.bricks) << i;
            EXPECT_EQ(found(threads).grid.side, one.grid.side) << i;
        }
    }
}

TEST(Bricks, stay_larger_where_the_effort_is_small) {
    const field::Field ball_of_1 = field::primitive("sphere", {1});
    const auto side = [&](std::size_t operations) {
        return bricks(ball_of_1, ball_of_1.root, {}, ball, {.side = 64, .operations = operations})
            .grid.side;
    };
    EXPECT_EQ(side(0), 1);
    EXPECT_LT(side(20'000), side(2'000'000));
    EXPECT_EQ(side(100'000'000), 64);
}

TEST(Bricks, are_less_decided_when_time_runs_out_and_never_wrong) {
    constexpr unsigned seed = 20261123;
    eval::Random random(seed);
    int coarse = 0;
    for (int i = 0; i < 60; ++i) {
        const RandomScene scene(random, i % 3 == 0);
        const auto found = [&](const Budget* budget) {
            return bricks(scene.field, scene.field.root, scene.parameters, ball,
                          {.side = 8, .threads = 1 + i % 2, .budget = budget});
        };
        const Bricks fine = found(nullptr);
        for (const int questions : {0, 1, 2, 5, 20, 100}) {
            SCOPED_TRACE("scene " + std::to_string(i) + ", seed " + std::to_string(seed) + ", " +
                         std::to_string(questions) + " questions");
            const Budget budget = over_after(questions);
            const Bricks some = found(&budget);
            coarse += budget.was_over();
            if (!budget.was_over()) {
                EXPECT_EQ(some.bricks, fine.bricks);
            }
            ASSERT_LE(some.grid.side, fine.grid.side);
            const int ratio = fine.grid.side / some.grid.side;
            // What is decided of a large brick is decided of all within it; a brick that is outside
            // of the region may be either.
            for (std::size_t k = 0; k < fine.bricks.size(); ++k) {
                const Brick large = some.at(fine.grid.at(k) / ratio);
                const bool beyond = !clip(ball, fine.grid.widened(fine.grid.at(k)));
                if (large != Brick::surface && !beyond) {
                    EXPECT_EQ(fine.bricks[k], large) << k;
                }
            }
        }
        const Budget enough = over_after(1'000'000);
        EXPECT_EQ(found(&enough).bricks, fine.bricks);
        EXPECT_FALSE(enough.was_over());
    }
    EXPECT_GT(coarse, 100);
}

}  // namespace
}  // namespace analysis
