// SPDX-License-Identifier: MIT
// The operators for double where they differ from C's functions.
#include "numeric/real.h"

#include <gtest/gtest.h>

namespace {

using numeric::infinity;
using numeric::not_a_number;

TEST(Real, powers_of_negative_numbers_need_whole_exponents) {
    EXPECT_EQ(numeric::pow(-2, 3), -8);
    EXPECT_EQ(numeric::pow(-2, -2), 0.25);
    EXPECT_EQ(numeric::pow(-8, 0), 1);
    EXPECT_TRUE(std::isnan(numeric::pow(-8, 1.0 / 3)));
    EXPECT_TRUE(std::isnan(numeric::pow(-2, infinity)));
    EXPECT_EQ(numeric::pow(0, 0), 1);
    EXPECT_EQ(numeric::pow(0, -1), infinity);
}

TEST(Real, nan_goes_through_operators_in_which_c_loses_it) {
    const double nan = not_a_number;
    for (const double other : {0.0, 1.0, -infinity, infinity}) {
        EXPECT_TRUE(std::isnan(numeric::min(nan, other)) && std::isnan(numeric::min(other, nan)));
        EXPECT_TRUE(std::isnan(numeric::max(nan, other)) && std::isnan(numeric::max(other, nan)));
        EXPECT_TRUE(std::isnan(numeric::pow(nan, other)) && std::isnan(numeric::pow(other, nan)));
        EXPECT_TRUE(std::isnan(numeric::hypot(nan, other)));
        EXPECT_TRUE(std::isnan(numeric::hypot3(other, other, nan)));
        EXPECT_TRUE(std::isnan(numeric::ratio(nan, other)));
        EXPECT_TRUE(std::isnan(numeric::ratio(other, nan)));
        EXPECT_TRUE(std::isnan(numeric::select_less(nan, other, 1, 2)));
        EXPECT_TRUE(std::isnan(numeric::select_less(other, nan, 1, 2)));
    }
    EXPECT_TRUE(std::isnan(numeric::sign(nan)));
}

TEST(Real, select_less_takes_the_second_branch_for_equal_numbers) {
    EXPECT_EQ(numeric::select_less(1, 2, 10, 20), 10);
    EXPECT_EQ(numeric::select_less(2, 2, 10, 20), 20);
    EXPECT_EQ(numeric::select_less(1, 2, 10, not_a_number), 10);
}

TEST(Real, the_logarithm_of_zero_is_out_of_the_domain) {
    EXPECT_TRUE(std::isnan(numeric::log(0)));
    EXPECT_TRUE(std::isnan(numeric::log(-1)));
    EXPECT_EQ(numeric::log(1), 0);
}

TEST(Real, a_ratio_stays_within_one_and_is_zero_at_the_origin) {
    EXPECT_EQ(numeric::ratio(0, 0), 0);
    EXPECT_EQ(numeric::ratio(-3, 4), -0.75);
    EXPECT_EQ(numeric::ratio(std::nextafter(1.0, 2.0), 1), 1);
}

TEST(Real, the_sign_of_zero_does_not_turn_an_angle) {
    EXPECT_EQ(numeric::atan2(-0.0, -1), std::acos(-1.0));
    EXPECT_EQ(numeric::atan2(0.0, -0.0), 0);
}

TEST(Real, lengths_do_not_overflow_on_the_way) {
    EXPECT_NEAR(numeric::hypot3(1e300, 1e300, 1e300) / 1e300, std::sqrt(3.0), 1e-12);
    EXPECT_EQ(numeric::hypot3(infinity, 1, 1), infinity);
    EXPECT_EQ(numeric::hypot3(2, -3, 6), 7);
}

}  // namespace
