// SPDX-License-Identifier: MIT
// Where numbers stand on a logarithmic axis.
#include "studio/log_axis.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

using studio::log_axis;
using studio::LogAxis;

TEST(LogAxis, ends_at_round_numbers_around_the_values) {
    const double values[] = {0.3, 0, 47, 3};
    const LogAxis axis = log_axis(values, false);
    EXPECT_DOUBLE_EQ(axis.low, 0.2);
    EXPECT_DOUBLE_EQ(axis.high, 50);
    const double ends[] = {0.05, 200};
    EXPECT_DOUBLE_EQ(log_axis(ends, false).low, 0.05);
    EXPECT_DOUBLE_EQ(log_axis(ends, false).high, 200);
}

TEST(LogAxis, has_a_length_also_for_one_value_and_for_none) {
    const double one[] = {5};
    EXPECT_DOUBLE_EQ(log_axis(one, false).low, 5);
    EXPECT_DOUBLE_EQ(log_axis(one, false).high, 10);
    const double zeros[] = {0, 0};
    EXPECT_LT(log_axis(zeros, true).low, log_axis(zeros, true).high);
    EXPECT_LT(log_axis({}, false).low, log_axis({}, false).high);
}

TEST(LogAxis, puts_equal_factors_at_equal_distances) {
    const LogAxis axis{.low = 1, .high = 100};
    EXPECT_DOUBLE_EQ(axis.place(1), 0);
    EXPECT_DOUBLE_EQ(axis.place(10), 0.5);
    EXPECT_DOUBLE_EQ(axis.place(100), 1);
    EXPECT_DOUBLE_EQ(axis.place(1000), 1);
    EXPECT_DOUBLE_EQ(axis.place(0.1), 0);
}

TEST(LogAxis, keeps_a_place_for_zero) {
    const LogAxis axis{.low = 1, .high = 100, .zero = true};
    EXPECT_EQ(axis.place(0), 0);
    EXPECT_DOUBLE_EQ(axis.place(1), LogAxis::zero_share);
    EXPECT_DOUBLE_EQ(axis.place(10), LogAxis::zero_share + (1 - LogAxis::zero_share) / 2);
    EXPECT_DOUBLE_EQ(axis.place(100), 1);
}

TEST(LogAxis, has_its_ends_among_few_ticks) {
    EXPECT_EQ((LogAxis{.low = 0.5, .high = 20}).ticks(),
              (std::vector<double>{0.5, 1, 2, 5, 10, 20}));
    EXPECT_EQ((LogAxis{.low = 1, .high = 10000}).ticks(),
              (std::vector<double>{1, 10, 100, 1000, 10000}));
}

TEST(LogAxis, has_every_positive_value_on_it) {
    for (double value = 1e-6; value < 1e7; value *= 1.37) {
        const double values[] = {value};
        const LogAxis axis = log_axis(values, false);
        EXPECT_LE(axis.low, value);
        EXPECT_GE(axis.high, value);
        EXPECT_LT(axis.high, 6 * axis.low) << "no longer than needed";
    }
}

}  // namespace
