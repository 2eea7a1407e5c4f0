// SPDX-License-Identifier: MIT
#include "formula/number.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace formula {
namespace {

TEST(Number, takes_an_exponent_only_if_digits_follow) {
    EXPECT_EQ(number_length("2e+1"), 4u);
    EXPECT_EQ(number_length("2e1x"), 3u);
    EXPECT_EQ(number_length("2E-3"), 4u);
    EXPECT_EQ(number_length("2e"), 1u);
    EXPECT_EQ(number_length("2e+"), 1u);
    EXPECT_EQ(number_length("2ex"), 1u);
    EXPECT_EQ(number_length("2.5e-3"), 6u);
}

TEST(Number, needs_a_digit_on_one_side_of_the_point) {
    EXPECT_EQ(number_length(".5"), 2u);
    EXPECT_EQ(number_length("1."), 2u);
    EXPECT_EQ(number_length("1.e2"), 4u);
    EXPECT_EQ(number_length("."), 0u);
    EXPECT_EQ(number_length(".e1"), 0u);
    EXPECT_EQ(number_length("e1"), 0u);
    EXPECT_EQ(number_length(""), 0u);
    EXPECT_EQ(number_length("1.2.3"), 3u);
}

TEST(Number, has_the_nearest_value) {
    EXPECT_EQ(number_value("2e+1"), 20.0);
    EXPECT_EQ(number_value(".5"), 0.5);
    EXPECT_EQ(number_value("1."), 1.0);
    EXPECT_EQ(number_value("2.5e-3"), 0.0025);
    EXPECT_EQ(number_value("0.1"), 0.1);
}

TEST(Number, has_no_value_if_it_is_too_large) {
    EXPECT_EQ(number_value("1e308"), 1e308);
    EXPECT_EQ(number_value("1e309"), std::nullopt);
    EXPECT_EQ(number_value("1e99999999999999999999"), std::nullopt);
    EXPECT_EQ(number_value("0.001e400"), std::nullopt);
    EXPECT_EQ(number_value(std::string(400, '9')), std::nullopt);
    EXPECT_EQ(number_value(std::string(400, '9') + ".5"), std::nullopt);
}

TEST(Number, is_zero_if_it_is_too_small) {
    EXPECT_EQ(number_value("1e-400"), 0.0);
    EXPECT_EQ(number_value("1000e-400"), 0.0);
    EXPECT_EQ(number_value("1e-99999999999999999999"), 0.0);
    EXPECT_EQ(number_value("0." + std::string(400, '0') + "1"), 0.0);
    EXPECT_EQ(number_value("0e99999999999999999999"), 0.0);
}

}  // namespace
}  // namespace formula
