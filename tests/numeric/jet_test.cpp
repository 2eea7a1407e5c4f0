// SPDX-License-Identifier: MIT
// Jets with known answers, and what they say at kinks, jumps, poles and edges. That they agree with
// differences for every operator is tested with the evaluators.
#include "numeric/jet_operators.h"

#include <functional>

#include <gtest/gtest.h>

namespace numeric {
namespace {

using J = SecondOrder<double, 1>;
using B = SecondOrder<Interval, 1>;

J x_at(double at) { return J::variable(at, 0); }
B x_over(double lo, double hi) { return B::variable(Interval{lo, hi}, 0); }

TEST(Jet, has_the_derivatives_of_textbooks) {
    const J f = mul(exp(x_at(0)), sin(x_at(0)));
    EXPECT_EQ(f.value, 0);
    EXPECT_EQ(f.gradient[0], 1);
    EXPECT_EQ(f.hessian[0], 2);
    const J g = div(J(1), x_at(2));
    EXPECT_EQ(g.value, 0.5);
    EXPECT_EQ(g.gradient[0], -0.25);
    EXPECT_EQ(g.hessian[0], 0.25);
}

TEST(Jet, packs_the_hessian_row_by_row) {
    using P = SecondOrder<double>;
    const P x = P::variable(2, 0), y = P::variable(3, 1), z = P::variable(5, 2);
    // x^2 y + y z
    const P f = add(mul(square(x), y), mul(y, z));
    EXPECT_EQ(f.value, 27);
    EXPECT_EQ(f.gradient, (std::array{12.0, 9.0, 3.0}));
    EXPECT_EQ(f.hessian, (std::array{6.0, 4.0, 0.0, 0.0, 1.0, 0.0}));
    EXPECT_FALSE(f.has_bend(triangle_place(0, 2, 3))) << "x and z never meet in a product";
    EXPECT_TRUE(f.smooth);
}

TEST(Jet, along_a_ray_holds_the_derivatives_by_its_parameter) {
    // The circle x^2 + y^2 - 1 along (3, 4) + t (-0.6, -0.8): (5 - t)^2 - 1.
    const J f = sub(add(square(J::along(3, -0.6)), square(J::along(4, -0.8))), J(1));
    EXPECT_DOUBLE_EQ(f.value, 24);
    EXPECT_DOUBLE_EQ(f.gradient[0], -10);
    EXPECT_DOUBLE_EQ(f.hessian[0], 2);
}

TEST(Jet, of_the_first_order_is_the_same_without_the_hessian) {
    const auto f = hypot(Dual<double, 2>::variable(3, 0), Dual<double, 2>::variable(4, 1));
    EXPECT_EQ(f.value, 5);
    EXPECT_DOUBLE_EQ(f.gradient[0], 0.6);
    EXPECT_DOUBLE_EQ(f.gradient[1], 0.8);
    EXPECT_TRUE(f.hessian.empty());
}

struct Place {
    const char* name;
    std::function<J(J)> at;
    std::function<B(B)> over;
    double kink;    ///< here it is not smooth
    double smooth;  ///< here it is, and within 0.25
};

#define ZEROSET_PLACE(text, kink, smooth)                                       \
    Place {                                                                     \
#text, [](J x) { return text; }, [](B x) { return text; }, kink, smooth \
    }

/// A constant of the same kind as x.
J number(const J&, double value) { return J(value); }
B number(const B&, double value) { return B(Interval(value)); }

TEST(Jet, says_so_at_kinks_jumps_poles_and_edges) {
    const Place places[] = {
        ZEROSET_PLACE(abs(x), 0, 1),
        ZEROSET_PLACE(min(x, number(x, 2)), 2, 1),
        ZEROSET_PLACE(max(x, number(x, 2)), 2, 3),
        ZEROSET_PLACE(select_less(x, number(x, 1), x, mul(x, x)), 1, 2),
        ZEROSET_PLACE(sign(x), 0, 1),
        ZEROSET_PLACE(floor(x), 3, 2.5),
        ZEROSET_PLACE(ceil(x), 3, 2.5),
        ZEROSET_PLACE(hypot(x, number(x, 0)), 0, 1),
        ZEROSET_PLACE(hypot3(x, x, number(x, 0)), 0, 1),
        ZEROSET_PLACE(sqrt(x), 0, 1),
        ZEROSET_PLACE(cbrt(x), 0, 1),
        ZEROSET_PLACE(pow(x, number(x, 0.5)), 0, 1),
        ZEROSET_PLACE(pow(x, number(x, 2.5)), 0, 1),
        ZEROSET_PLACE(pow(x, number(x, -2)), 0, 1),
        ZEROSET_PLACE(pow(x, x), 0, 1),
        ZEROSET_PLACE(div(number(x, 1), x), 0, 1),
        ZEROSET_PLACE(log(x), 0, 1),
        ZEROSET_PLACE(asin(x), 1, 0.5),
        ZEROSET_PLACE(acos(x), -1, 0.5),
        ZEROSET_PLACE(atan2(x, number(x, -1)), 0, 1),
        ZEROSET_PLACE(atan2(x, x), 0, 1),
        ZEROSET_PLACE(ratio(x, abs(x)), 0, 1),
        ZEROSET_PLACE(sqrt(sub(x, number(x, 3))), 2, 4),
    };
    for (const Place& p : places) {
        EXPECT_FALSE(p.at(x_at(p.kink)).smooth) << p.name;
        EXPECT_TRUE(p.at(x_at(p.smooth)).smooth) << p.name;
        EXPECT_FALSE(p.over(x_over(p.kink, p.kink)).smooth) << p.name;
        EXPECT_FALSE(p.over(x_over(p.kink - 0.25, p.kink + 0.25)).smooth) << p.name;
        EXPECT_FALSE(p.over(x_over(p.kink, p.kink + 0.25)).smooth) << p.name;
        EXPECT_FALSE(p.over(x_over(p.kink - 0.25, p.kink)).smooth) << p.name;
        EXPECT_TRUE(p.over(x_over(p.smooth - 0.25, p.smooth + 0.25)).smooth) << p.name;
        // Behind a smooth function it is still said.
        EXPECT_FALSE(cos(p.at(x_at(p.kink))).smooth) << p.name;
        EXPECT_FALSE(cos(p.over(x_over(p.kink - 0.25, p.kink + 0.25))).smooth) << p.name;
    }
}

TEST(Jet, has_the_derivatives_of_one_side_at_a_kink) {
    EXPECT_EQ(abs(x_at(0)).gradient[0], 0);
    EXPECT_EQ(min(x_at(2), J(2)).gradient[0], 1) << "of two equal numbers the first counts";
    EXPECT_EQ(max(J(2), x_at(2)).gradient[0], 0);
    EXPECT_EQ(hypot(x_at(0), J(0)).gradient[0], 0);
    EXPECT_EQ(floor(x_at(3)).gradient[0], 0);
    const Interval both = abs(x_over(-1, 2)).gradient[0];
    EXPECT_EQ(both, (Interval{next_down(-1), next_up(1), false, true}));
}

TEST(Jet, of_a_length_that_stays_0_has_no_second_derivatives) {
    using J2 = SecondOrder<double, 1>;
    using B2 = SecondOrder<Interval, 1>;
    const auto shell = [](auto x) {
        using Kind = decltype(x);
        const auto number = [](double value) { return Kind(typename Kind::Number(value)); };
        return hypot(max(x, number(0)), max(sub(x, number(1)), number(0)));
    };
    EXPECT_EQ(shell(J2::variable(-1, 0)).gradient[0], 0);
    EXPECT_EQ(shell(J2::variable(-1, 0)).hessian[0], 0);
    EXPECT_EQ(shell(B2::variable({-2, -1}, 0)).hessian[0], Interval(0));
    EXPECT_EQ(hypot3(J2::variable(0, 0), J2(0), J2(0)).hessian[0], 0);
    const J2 least = max(J2::variable(-1, 0), J2(0));
    EXPECT_EQ(ratio(least, least).gradient[0], 0);
    EXPECT_EQ(ratio(least, least).hessian[0], 0);
    EXPECT_FALSE(shell(J2::variable(0, 0)).smooth);
}

TEST(Jet, of_something_that_does_not_vary_is_smooth_everywhere) {
    EXPECT_TRUE(sqrt(J(0)).smooth);
    EXPECT_TRUE(abs(J(0)).smooth);
    EXPECT_TRUE(floor(J(3)).smooth);
    EXPECT_TRUE(min(J(3), J(3)).smooth);
    EXPECT_TRUE(hypot(B(Interval(0)), B(Interval(0))).smooth);
    // 0 stays 0 where the chain rule would multiply it by the infinite slope of the root.
    const J f = add(sqrt(J(0)), x_at(1));
    EXPECT_EQ(f.gradient[0], 1);
    EXPECT_TRUE(f.smooth);
    EXPECT_FALSE(log(J(-1)).smooth) << "but it needs a value";
}

TEST(Jet, over_intervals_carries_the_edge_of_a_domain) {
    const B f = sqrt(x_over(-1, 4));
    EXPECT_EQ(f.value.lo, 0);
    EXPECT_TRUE(f.value.partial);
    EXPECT_TRUE(f.gradient[0].partial);
    EXPECT_LE(f.gradient[0].lo, 0.25);
    EXPECT_EQ(f.gradient[0].hi, infinity);
    EXPECT_TRUE(sqrt(x_over(-3, -1)).value.is_empty());
    EXPECT_TRUE(sqrt(x_over(-3, -1)).gradient[0].is_empty());
}

}  // namespace
}  // namespace numeric
