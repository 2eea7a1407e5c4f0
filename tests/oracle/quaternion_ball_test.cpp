// SPDX-License-Identifier: MIT
#include "oracle/quaternion_ball.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "oracle/quaternion.h"

namespace oracle {
namespace {

/// With a radius, or so small a one that only the rounding of the results counts.
template <class Real>
QuaternionBall<Real> random_ball(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const double size = std::exp2(8 * normal(random));
    std::array<Real, 4> centre;
    for (Real& each : centre)
        each = static_cast<Real>(size) / 3 * static_cast<Real>(normal(random));
    const double part = std::exp2(-10 * std::abs(normal(random)));
    return {centre, random() % 2 == 0 ? 0 : size * part};
}

/// On the ball's edge.
template <class Real>
Exact random_member(const QuaternionBall<Real>& of, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const __float128 tiny = 0x1p-100;
    Exact way, result;
    for (__float128& each : way) each = normal(random);
    const __float128 part = of.radius * (1 - tiny) / length(way);
    for (std::size_t i = 0; i < 4; ++i) result[i] = of.centre[i] + part * way[i];
    return result;
}

template <class Real>
void expect_in(const Exact& exact, const QuaternionBall<Real>& result) {
    Exact off;
    for (std::size_t i = 0; i < 4; ++i) off[i] = exact[i] - result.centre[i];
    EXPECT_TRUE(length(off) <= result.radius);
}

template <class Real>
void expect_results_of_members_in_balls() {
    std::mt19937_64 random(20261122);
    for (int i = 0; i < 20'000; ++i) {
        const QuaternionBall<Real> a = random_ball<Real>(random), b = random_ball<Real>(random);
        const QuaternionBall<double> c = random_ball<double>(random);
        const Exact p = random_member(a, random), q = random_member(b, random),
                    r = random_member(c, random);
        Exact total, half = anti_commutator(p, p);
        __float128 inner = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            total[k] = p[k] + q[k];
            half[k] /= 2;
            inner += p[k] * r[k];
        }
        expect_in(total, sum(a, b));
        expect_in(half, square(a));
        expect_in(anti_commutator(p, r), products(a, c));
        const numeric::Interval products_of_members = inner_product(a, c), norms = norm(a);
        EXPECT_TRUE(products_of_members.lo <= inner && inner <= products_of_members.hi);
        const __float128 exact = length(p) * length(p);
        EXPECT_TRUE(norms.lo <= exact && exact <= norms.hi);
        // And no larger than the products of the ball itself.
        constexpr double rounding = 10 * static_cast<double>(std::numeric_limits<Real>::epsilon());
        EXPECT_LE(square(a).radius,
                  (2 * a.length + a.radius) * a.radius * (1 + 1e-14) + rounding * norms.hi);
    }
}

TEST(QuaternionBall, holds_the_results_of_members) {
    expect_results_of_members_in_balls<double>();
    expect_results_of_members_in_balls<long double>();
}

TEST(QuaternionBall, adds_nothing_to_nothing) {
    const QuaternionBall<double> a{{1, 2, 3, 4}, 0.5}, nothing{};
    EXPECT_EQ(sum(a, nothing).centre, a.centre);
    EXPECT_GE(sum(a, nothing).radius, 0.5);
    EXPECT_LE(sum(a, nothing).radius, 0.5 + 1e-14);
}

}  // namespace
}  // namespace oracle
