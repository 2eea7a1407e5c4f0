// SPDX-License-Identifier: MIT
#include "analysis/spectral_norm.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace analysis {
namespace {

using numeric::Interval;

constexpr unsigned seed = 31;

TEST(SpectralNorm, is_the_largest_absolute_eigenvalue) {
    const auto near = [](double bound, double norm) {
        EXPECT_GE(bound, norm * (1 - 1e-14));
        EXPECT_LE(bound, norm * 1.02);
    };
    near(spectral_norm_bound(Symmetric<double>{3, -7, 5, 0, 0, 0}), 7);
    near(spectral_norm_bound(Symmetric<double>{2, 2, 2, 0, 0, 0}), 2);
    near(spectral_norm_bound(Symmetric<double>{1, 1, 1, 1, 1, 1}), 3);
    near(spectral_norm_bound(Symmetric<double>{0, 0, 0, 1e200, 0, 0}), 1e200);
    near(spectral_norm_bound(Symmetric<double>{1e-300, 0, 0, 0, 0, 0}), 1e-300);
    EXPECT_EQ(spectral_norm_bound(Symmetric<double>{}), 0);
    EXPECT_EQ(spectral_norm_bound(Symmetric<double>{numeric::infinity, 0, 0, 0, 0, 0}),
              numeric::infinity);
}

TEST(SpectralNorm, of_intervals_is_above_every_matrix_in_them) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-2, 2), part(0, 1);
    const auto interval = [&] {
        const double a = uniform(random), b = uniform(random);
        return Interval{std::min(a, b), std::max(a, b)};
    };
    for (int i = 0; i < 2000; ++i) {
        const Symmetric<Interval> a{interval(), interval(), interval(),
                                    interval(), interval(), interval()};
        const auto pick = [&](const Interval& from) {
            return from.lo + part(random) * (from.hi - from.lo);
        };
        const Symmetric<double> m{pick(a.xx), pick(a.yy), pick(a.zz),
                                  pick(a.xy), pick(a.xz), pick(a.yz)};
        // The bound of a single matrix may itself be 2 % too large.
        ASSERT_GE(spectral_norm_bound(a) * 1.02, spectral_norm_bound(m)) << "seed " << seed;
        ASSERT_GE(frobenius_norm_bound(a) * 1.02, spectral_norm_bound(m)) << "seed " << seed;
    }
}

TEST(SpectralNorm, keeps_the_signs_of_narrow_intervals) {
    // With the absolute values of its entries this matrix has the norm 3, with its signs 2.
    const double e = 1e-6;
    const Interval one{1 - e, 1 + e}, minus_one{-1 - e, -1 + e};
    EXPECT_LE(spectral_norm_bound(Symmetric<Interval>{one, one, one, one, one, minus_one}), 2.05);
}

TEST(SpectralNorm, of_unbounded_intervals_is_infinite) {
    EXPECT_EQ(spectral_norm_bound(Symmetric<Interval>{Interval::whole(), 0.0, 0.0, 0.0, 0.0, 0.0}),
              numeric::infinity);
}

}  // namespace
}  // namespace analysis
