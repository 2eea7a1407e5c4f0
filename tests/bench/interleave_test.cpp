// SPDX-License-Identifier: MIT
#include "bench/interleave.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace bench {
namespace {

/// The numbers in the order in which they were drawn.
std::vector<std::size_t> order(std::size_t count, int rounds, std::uint32_t seed) {
    std::vector<std::size_t> drawn;
    interleave(std::vector<int>(count, rounds), seed, [&](std::size_t i) {
        drawn.push_back(i);
        return 0.0;
    });
    return drawn;
}

TEST(Interleave, draws_each_once_a_round) {
    const auto drawn = order(10, 4, 3);
    ASSERT_EQ(drawn.size(), 40U);
    for (int round = 0; round < 4; ++round) {
        const std::set<std::size_t> seen(drawn.begin() + 10 * round,
                                         drawn.begin() + 10 * round + 10);
        EXPECT_EQ(seen.size(), 10U) << "round " << round;
    }
}

TEST(Interleave, shuffles_each_round_by_the_seed) {
    const auto drawn = order(10, 2, 3);
    EXPECT_FALSE(std::equal(drawn.begin(), drawn.begin() + 10, drawn.begin() + 10));
    EXPECT_EQ(drawn, order(10, 2, 3));
    EXPECT_NE(drawn, order(10, 2, 4));
}

TEST(Interleave, leaves_some_out_of_later_rounds) {
    const auto results = interleave(std::vector<int>{4, 2, 0}, 1, [](std::size_t) { return 1.0; });
    EXPECT_EQ(results[0].size(), 4U);
    EXPECT_EQ(results[1].size(), 2U);
    EXPECT_TRUE(results[2].empty());
    EXPECT_TRUE(interleave({}, 1, [](std::size_t) { return 1.0; }).empty());
}

TEST(Interleave, gives_results_by_number_and_round) {
    double clock = 0;
    const auto results = interleave(std::vector<int>(3, 5), 1, [&](std::size_t i) {
        clock += 100;
        return clock + static_cast<double>(i);
    });
    ASSERT_EQ(results.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(results[i].size(), 5U);
        EXPECT_TRUE(std::ranges::is_sorted(results[i]));
        for (const double result : results[i]) {
            EXPECT_EQ(static_cast<std::size_t>(result) % 100, i);
        }
    }
}

}  // namespace
}  // namespace bench
