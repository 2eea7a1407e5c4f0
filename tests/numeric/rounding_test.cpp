// SPDX-License-Identifier: MIT
// Directed rounding against arithmetic in long double, which holds sums and products of doubles of
// like size exactly enough to tell the side.
#include "numeric/rounding.h"

#include <random>

#include <gtest/gtest.h>

namespace {

constexpr unsigned seed = 4711;
constexpr double tiny = std::numeric_limits<double>::denorm_min();
constexpr double huge = std::numeric_limits<double>::max();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Rounding, neighbours_are_those_of_the_standard_library) {
    for (const double x : {0.0, -0.0, 1.0, -1.0, tiny, -tiny, huge, -huge, 0x1p-1022, 1e10}) {
        EXPECT_EQ(numeric::next_up(x), std::nextafter(x, infinity)) << x;
        EXPECT_EQ(numeric::next_down(x), std::nextafter(x, -infinity)) << x;
    }
    EXPECT_EQ(numeric::next_up(infinity), infinity);
    EXPECT_EQ(numeric::next_up(-infinity), -huge);
    EXPECT_EQ(numeric::next_down(-infinity), -infinity);
}

TEST(Rounding, sums_are_rounded_to_the_nearest_double_on_each_side) {
    EXPECT_EQ(numeric::add_down(1, 2), 3);
    EXPECT_EQ(numeric::add_up(1, 2), 3);
    EXPECT_EQ(numeric::add_down(1, 1e-30), 1);
    EXPECT_EQ(numeric::add_up(1, 1e-30), std::nextafter(1.0, 2.0));
    EXPECT_EQ(numeric::add_up(huge, huge), infinity);
    EXPECT_EQ(numeric::add_down(huge, huge), huge);
    EXPECT_EQ(numeric::add_up(-huge, -huge), -huge);
    EXPECT_EQ(numeric::add_down(infinity, 1), huge);
}

TEST(Rounding, zero_factors_are_exact_and_underflow_is_not) {
    EXPECT_EQ(numeric::mul_down(0, infinity), 0);
    EXPECT_EQ(numeric::mul_up(0, -1), 0);
    EXPECT_EQ(numeric::mul_down(tiny, tiny), 0);
    EXPECT_EQ(numeric::mul_up(tiny, tiny), tiny);
    EXPECT_EQ(numeric::mul_down(-tiny, tiny), -tiny);
    EXPECT_EQ(numeric::mul_up(-tiny, tiny), 0);
    EXPECT_EQ(numeric::div_up(tiny, huge), tiny);
    EXPECT_EQ(numeric::div_down(0, 3), 0);
}

TEST(Rounding, results_enclose_the_exact_ones) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-10, 10);
    for (int i = 0; i < 100000; ++i) {
        const double a = uniform(random), b = uniform(random);
        const long double x = a, y = b;
        EXPECT_LE(numeric::add_down(a, b), x + y) << "seed " << seed;
        EXPECT_GE(numeric::add_up(a, b), x + y) << "seed " << seed;
        EXPECT_LE(numeric::mul_down(a, b), x * y) << "seed " << seed;
        EXPECT_GE(numeric::mul_up(a, b), x * y) << "seed " << seed;
        EXPECT_LE(numeric::div_down(a, b), x / y) << "seed " << seed;
        EXPECT_GE(numeric::div_up(a, b), x / y) << "seed " << seed;
        EXPECT_LE(numeric::add_up(a, b), numeric::next_up(numeric::add_down(a, b)));
    }
}

}  // namespace
