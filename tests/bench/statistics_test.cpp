// SPDX-License-Identifier: MIT
#include "bench/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace bench {
namespace {

TEST(Statistics, quantiles_of_known_lists) {
    const std::array five{5.0, 1.0, 4.0, 2.0, 3.0};
    EXPECT_DOUBLE_EQ(quantile(five, 0), 1);
    EXPECT_DOUBLE_EQ(quantile(five, 0.25), 2);
    EXPECT_DOUBLE_EQ(quantile(five, 0.5), 3);
    EXPECT_DOUBLE_EQ(quantile(five, 1), 5);
    const std::array four{10.0, 20.0, 30.0, 40.0};
    EXPECT_DOUBLE_EQ(quantile(four, 0.5), 25);
    EXPECT_DOUBLE_EQ(quantile(four, 0.25), 17.5);
    EXPECT_DOUBLE_EQ(quantile(std::array{7.0}, 0.9), 7);
    EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(Statistics, quartiles_are_three_quantiles) {
    const Quartiles q = quartiles(std::array{1.0, 2.0, 3.0, 4.0, 100.0});
    EXPECT_DOUBLE_EQ(q.lower, 2);
    EXPECT_DOUBLE_EQ(q.median, 3);
    EXPECT_DOUBLE_EQ(q.upper, 4);
}

TEST(Statistics, a_geometric_mean_of_a_ratio_and_its_inverse_is_one) {
    EXPECT_DOUBLE_EQ(geometric_mean(std::array{4.0, 0.25}), 1);
    EXPECT_DOUBLE_EQ(geometric_mean(std::array{1.0, 10.0, 100.0}), 10);
    EXPECT_TRUE(std::isnan(geometric_mean({})));
}

TEST(Statistics, a_ratio_by_rounds_does_not_see_slow_moments) {
    // In the second and third round the machine was ten times as slow.
    const std::array a{2.0, 20.0, 20.0, 2.0, 2.0};
    const std::array b{1.0, 10.0, 10.0, 1.0, 1.0};
    const Quartiles ratio = paired_ratio(a, b);
    EXPECT_DOUBLE_EQ(ratio.lower, 2);
    EXPECT_DOUBLE_EQ(ratio.median, 2);
    EXPECT_DOUBLE_EQ(ratio.upper, 2);
}

/// Times of a frame as a machine shows them: a few percent of noise, and now and then a jump.
std::vector<double> times(double typical, int count, std::mt19937& random) {
    std::normal_distribution<double> noise(0, 0.03);
    std::vector<double> list;
    for (int i = 0; i < count; ++i) {
        const bool interrupted = random() % 12 == 0;
        list.push_back(typical * std::exp(noise(random)) * (interrupted ? 1.5 : 1));
    }
    return list;
}

TEST(Statistics, the_interval_of_a_ratio_holds_the_true_one) {
    std::mt19937 random(20);
    int held = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const auto interval = ratio_of_medians(times(1, 9, random), times(1.3, 9, random), 0.99, 1);
        ASSERT_LT(interval.low, interval.high);
        held += interval.low <= 1.3 && 1.3 <= interval.high;
    }
    // Of 300 it should be 297; with nine samples it is a few less.
    EXPECT_GE(held, 285);
}

TEST(Statistics, the_interval_of_a_ratio_is_as_narrow_as_the_noise) {
    std::mt19937 random(21);
    const auto interval = ratio_of_medians(times(1, 15, random), times(2, 15, random), 0.99, 1);
    EXPECT_GT(interval.low, 1.8);
    EXPECT_LT(interval.high, 2.2);
    const auto exact = ratio_of_medians(std::array{1.0, 1.0}, std::array{3.0, 3.0}, 0.99, 1);
    EXPECT_DOUBLE_EQ(exact.low, 3);
    EXPECT_DOUBLE_EQ(exact.high, 3);
}

}  // namespace
}  // namespace bench
