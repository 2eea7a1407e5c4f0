// SPDX-License-Identifier: MIT
// Intervals with known answers: the real extrema, and the flags. That they enclose sampled values
// for every operator is tested with the evaluators.
#include "numeric/interval.h"

#include <gtest/gtest.h>

namespace numeric {
namespace {

constexpr double pi = 3.14159265358979323846;

/// The result has these ends up to a few units in the last place, encloses them, and has these
/// flags.
void check(const Interval& result, const Interval& expected) {
    const auto near = [](double a, double b) {
        return a == b || std::abs(a - b) <= 1e-14 * std::max(1.0, std::abs(b));
    };
    EXPECT_TRUE(near(result.lo, expected.lo) && near(result.hi, expected.hi))
        << "[" << result.lo << ", " << result.hi << "] instead of [" << expected.lo << ", "
        << expected.hi << "]";
    EXPECT_LE(result.lo, expected.lo);
    EXPECT_GE(result.hi, expected.hi);
    EXPECT_EQ(result.partial, expected.partial);
    EXPECT_EQ(result.jumps, expected.jumps);
}

constexpr bool partial = true, total = false, jumps = true;

TEST(Interval, arithmetic_has_the_real_extrema) {
    check(add({1, 2}, {-3, 5}), {-2, 7});
    check(sub({1, 2}, {-3, 5}), {-4, 5});
    check(mul({-2, 3}, {-5, 4}), {-15, 12});
    check(mul({0, 1}, {1, infinity}), {0, infinity, partial});
    check(square({-2, 1}), {0, 4});
    check(div({1, 2}, {4, 8}), {0.125, 0.5});
}

TEST(Interval, numbers_stay_numbers_where_arithmetic_is_exact) {
    EXPECT_EQ(mul(Interval(3), sub(Interval(8), Interval(0.5))), Interval(22.5));
    EXPECT_EQ(sub(Interval(0.5), Interval(0.5)), Interval(0.0));
}

TEST(Interval, division_by_zero_is_a_half_line_or_the_whole_line) {
    check(div({1, 2}, {0, 4}), {0.25, infinity, partial});
    check(div({1, 2}, {-4, 0}), {-infinity, -0.25, partial});
    check(div({-1, 2}, {0, 4}), {-infinity, infinity, partial});
    check(div({1, 2}, {-1, 1}), {-infinity, infinity, partial});
    EXPECT_TRUE(div({1, 2}, {0, 0}).is_empty());
    check(div({0, 0}, {0, 4}), {0, 0, partial});
}

TEST(Interval, whole_powers_know_their_monotone_pieces) {
    check(pow({-2, 1}, 2.0), {0, 4});
    check(pow({-2, 1}, 3.0), {-8, 1});
    check(pow({-3, -2}, 2.0), {4, 9});
    check(pow({-3, -2}, 3.0), {-27, -8});
    check(pow({-2, 4}, -2.0), {0.0625, infinity, partial});
    check(pow({0, 4}, -1.0), {0.25, infinity, partial});
    check(pow({-4, 0}, -1.0), {-infinity, -0.25, partial});
    check(pow({-4, 2}, -1.0), {-infinity, infinity, partial});
    check(pow({-4, -2}, -3.0), {-0.125, -0.015625});
    check(pow({-4, 2}, 0.0), {1, 1});
    EXPECT_TRUE(pow({0, 0}, -2.0).is_empty());
}

TEST(Interval, other_powers_are_partial_for_negative_bases) {
    check(pow({4, 9}, 0.5), {2, 3});
    check(pow({-1, 9}, 0.5), {0, 3, partial});
    check(pow({4, 9}, -0.5), {1.0 / 3, 0.5});
    check(pow({0.5, 2}, {-1, 2}), {0.25, 4});
    check(pow({-2, 1}, {1, 3}), {-8, 8, partial});
    EXPECT_TRUE(pow({-2, -1}, 0.5).is_empty());
}

TEST(Interval, roots_clip_their_domain) {
    check(sqrt({4, 9}), {2, 3});
    check(sqrt({-4, 9}), {0, 3, partial});
    check(sqrt({0, 9}), {0, 3});
    EXPECT_TRUE(sqrt({-4, -1}).is_empty());
    check(cbrt({-8, 27}), {-2, 3});
    check(hypot({-3, 1}, {4, 4}), {4, 5});
    check(hypot3({-3, 1}, {4, 4}, {0, 12}), {4, 13});
}

TEST(Interval, sine_and_cosine_find_their_extrema) {
    check(sin({0, pi}), {0, 1});
    check(sin({1, 2}), {std::sin(1.0), 1});
    check(sin({4, 5}), {-1, std::sin(4.0)});
    check(sin({-0.5, 0.5}), {std::sin(-0.5), std::sin(0.5)});
    check(sin({0, 10}), {-1, 1});
    check(cos({-1, 2}), {std::cos(2.0), 1});
    check(cos({3, 4}), {-1, std::cos(4.0)});
    check(cos({0.5, 0.75}), {std::cos(0.75), std::cos(0.5)});
    check(sin({-infinity, 0}), {-1, 1, partial});
}

TEST(Interval, sine_of_a_huge_number_is_still_an_enclosure) {
    check(sin(Interval(1e10)), {std::sin(1e10), std::sin(1e10)});
    check(sin({1e300, 1e300}), {-1, 1});
}

TEST(Interval, tangent_knows_its_poles) {
    check(tan({-1, 1.5}), {std::tan(-1.0), std::tan(1.5)});
    check(tan({2, 4}), {std::tan(2.0), std::tan(4.0)});
    check(tan({1, 2}), {-infinity, infinity, partial});
}

TEST(Interval, inverse_functions_clip_their_domain) {
    check(asin({-0.5, 2}), {std::asin(-0.5), pi / 2, partial});
    check(acos({-2, 0.5}), {std::acos(0.5), pi, partial});
    check(acos({-1, 1}), {0, pi});
    EXPECT_TRUE(acos({2, 3}).is_empty());
    check(atan({-infinity, 1}), {-pi / 2, pi / 4});
    check(log({1, std::exp(1.0)}), {0, 1});
    check(log({-1, 1}), {-infinity, 0, partial});
    EXPECT_TRUE(log({-1, 0}).is_empty());
}

TEST(Interval, the_angle_jumps_at_the_negative_axis_only) {
    check(atan2({1, 2}, {-1, 1}), {std::atan2(1.0, 1.0), std::atan2(1.0, -1.0)});
    check(atan2({0, 1}, {-2, -1}), {std::atan2(1.0, -1.0), pi});
    check(atan2({-1, 1}, {-2, -1}), {-pi, pi, total, jumps});
    check(atan2({-1, 0}, {-2, -1}), {-pi, pi, total, jumps});
    check(atan2({-1, 1}, {1, 2}), {-pi / 4, pi / 4});
    check(atan2({-1, 1}, {0, 2}), {-pi / 2, pi / 2, total, jumps});
    check(atan2({0, 1}, {-1, 2}), {0, pi, total, jumps});
    check(atan2({-1, 1}, {-1, 2}), {-pi, pi, total, jumps});
}

TEST(Interval, hyperbolic_functions_keep_their_ranges) {
    check(cosh({-1, 0.5}), {1, std::cosh(1.0)});
    check(tanh({-infinity, infinity}), {-1, 1});
    check(sinh({0, 1}), {0, std::sinh(1.0)});
    check(exp({-infinity, 0}), {0, 1});
}

TEST(Interval, steps_jump_only_where_they_change) {
    check(floor({0.25, 0.75}), {0, 0});
    check(floor({0.25, 1}), {0, 1, total, jumps});
    check(ceil({0.25, 1}), {1, 1});
    check(sign({-1, 2}), {-1, 1, total, jumps});
    check(sign({1, 2}), {1, 1});
    check(floor(add(sign({-1, 2}), 0.0)), {-1, 1, total, jumps});
    check(floor(mul(sign({-1, 2}), 0.25)), {-1, 0, total, jumps});
    check(floor(add(mul(sign({-1, 2}), 0.25), 0.5)), {0, 0});
}

TEST(Interval, minimum_and_maximum_take_the_flags_of_what_they_show) {
    check(min({0, 3}, {1, 2}), {0, 2});
    check(max({0, 3}, {1, 2}), {1, 3});
    check(min({0, 1}, {2, 3, total, jumps}), {0, 1});
    check(min({0, 2.5}, {2, 3, total, jumps}), {0, 2.5, total, jumps});
    check(max({0, 1, partial}, {2, 3}), {2, 3, partial});
}

TEST(Interval, a_ratio_is_within_one_and_jumps_at_the_origin) {
    check(ratio({-1, 1}, {1, 2}), {-1, 1});
    check(ratio({1, 2}, {4, 8}), {0.125, 0.5});
    check(ratio({-1, 1}, {0, 2}), {-1, 1, total, jumps});
    check(ratio({1, 1}, {0, 2}), {0.5, 1, total, jumps});
    check(ratio({0, 0}, {0, 0}), {0, 0});
}

TEST(Interval, select_less_takes_one_branch_where_it_is_decided) {
    check(select_less({0, 1}, {2, 3}, {5, 6}, {8, 9, partial}), {5, 6});
    check(select_less({2, 3}, {0, 2}, {5, 6}, {8, 9, partial}), {8, 9, partial});
    check(select_less({0, 2}, {1, 3}, {5, 6}, {8, 9}), {5, 9, total, jumps});
    check(select_less({0, 2}, {1, 3}, 7.0, 7.0), {7, 7});
    check(select_less({0, 1, partial}, {2, 3}, {5, 6}, {8, 9}), {5, 6, partial});
}

TEST(Interval, nothing_comes_of_nothing) {
    const Interval none = Interval::empty();
    EXPECT_TRUE(add(none, 1.0).is_empty());
    EXPECT_TRUE(mul(0.0, none).is_empty());
    EXPECT_TRUE(pow(none, 0.0).is_empty());
    EXPECT_TRUE(atan2(1.0, none).is_empty());
    EXPECT_TRUE(select_less(none, 1.0, 2.0, 3.0).is_empty());
    EXPECT_TRUE(none.partial);
    EXPECT_TRUE(Interval(not_a_number).is_empty());
}

}  // namespace
}  // namespace numeric
