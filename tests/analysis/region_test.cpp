// SPDX-License-Identifier: MIT
#include "analysis/region.h"

#include <random>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "analysis/supremum.h"

namespace analysis {
namespace {

constexpr unsigned seed = 99;
const Region ball{.centre = {5, -3, 1}, .half = glm::dvec3(2), .sphere = true};
const Region box{.centre = {5, -3, 1}, .half = {1, 2, 3}, .sphere = false};

bool is_in(const Cell& cell, glm::dvec3 p) {
    return glm::all(glm::lessThanEqual(cell.low, p)) && glm::all(glm::lessThanEqual(p, cell.high));
}

TEST(Region, clipping_keeps_every_point_of_the_region) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-2.5, 2.5);
    const auto vector = [&] {
        return glm::dvec3(uniform(random), uniform(random), uniform(random));
    };
    int empty = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 a = vector(), b = vector();
        const Cell cell{ball.centre + glm::min(a, b), ball.centre + glm::max(a, b)};
        const std::optional<Cell> clipped = clip(ball, cell);
        empty += !clipped;
        for (int k = 0; k < 50; ++k) {
            const glm::dvec3 p = glm::clamp(ball.centre + vector(), cell.low, cell.high);
            if (contains(ball, p)) {
                ASSERT_TRUE(clipped && is_in(*clipped, p)) << "seed " << seed;
            }
        }
    }
    EXPECT_GT(empty, 0);
}

TEST(Region, clipping_cuts_a_corner_cell_to_the_ball) {
    const Region unit{.half = glm::dvec3(1)};
    const std::optional<Cell> clipped = clip(unit, {{0.8, 0, 0}, {1, 1, 1}});
    ASSERT_TRUE(clipped);
    EXPECT_NEAR(clipped->high.y, 0.6, 1e-9);
    EXPECT_NEAR(clipped->high.z, 0.6, 1e-9);
    EXPECT_FALSE(clip(unit, {{0.6, 0.6, 0.6}, {1, 1, 1}}));
}

TEST(Region, halves_cover_a_cell_across_its_longest_side) {
    const auto [a, b] = halves({{0, 0, 0}, {1, 4, 2}});
    EXPECT_EQ(a.high, glm::dvec3(1, 2, 2));
    EXPECT_EQ(b.low, glm::dvec3(0, 2, 0));
}

TEST(Region, spread_points_are_inside_and_fill_it_evenly) {
    for (const Region& region : {ball, box}) {
        glm::dvec3 mean(0);
        constexpr unsigned count = 2000;
        for (unsigned i = 0; i < count; ++i) {
            const glm::dvec3 p = spread_point(region, i);
            ASSERT_TRUE(contains(region, p) || glm::distance(p, region.centre) < 2 * (1 + 1e-12));
            mean += p / static_cast<double>(count);
        }
        EXPECT_LT(glm::distance(mean, region.centre), 0.02);
    }
}

TEST(Supremum, is_enclosed_from_above) {
    // sup x + y over the ball is at the point of the ball in that direction.
    const auto bounds = [](const Cell& cell) {
        return CellBounds{cell.high.x + cell.high.y, cell.middle().x + cell.middle().y};
    };
    const double supremum = 2 + 2 * std::sqrt(2.0);
    const double found = supremum_bound(ball, Effort{.cells = 5000, .tolerance = 0.01}, bounds);
    EXPECT_GE(found, supremum);
    EXPECT_LE(found, supremum * 1.01);
}

TEST(Supremum, gives_up_early_where_there_is_no_bound) {
    int calls = 0;
    const auto bounds = [&](const Cell& cell) {
        ++calls;
        return CellBounds{cell.low.x <= 5 && 5 <= cell.high.x ? numeric::infinity : 1, 0};
    };
    EXPECT_EQ(supremum_bound(ball, Effort{}, bounds), numeric::infinity);
    EXPECT_LT(calls, 100);
}

}  // namespace
}  // namespace analysis
