// SPDX-License-Identifier: MIT
// The Menger sponge of the library against its definition.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "formula/fractals.h"

namespace formula {
namespace {

Fractal menger(int levels) { return Fractal("menger(" + std::to_string(levels) + ")"); }

/// By the definition: in the cube from -1 to 1, cut into 27, without the seven that touch the
/// middle of the cube or of a side, and so on in each of the twenty.
bool is_in_sponge(glm::dvec3 p, int levels) {
    if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > 1) return false;
    if (levels == 0) return true;
    int middles = 0;
    for (int i = 0; i < 3; ++i) {
        const double cell = std::clamp(std::floor((p[i] + 1) * 1.5), 0.0, 2.0);
        middles += cell == 1;
        p[i] = 3 * p[i] - 2 * (cell - 1);
    }
    return middles < 2 && is_in_sponge(p, levels - 1);
}

TEST(Menger, is_one_lipschitz) {
    for (const int levels : {0, 1, 3}) {
        expect_lipschitz(menger(levels), 11, 2, 1500);
    }
}

TEST(Menger, agrees_with_the_recursive_definition) {
    constexpr unsigned seed = 12;
    Random random(seed);
    for (int levels = 0; levels <= 4; ++levels) {
        const Fractal sponge = menger(levels);
        for (int i = 0; i < 1500; ++i) {
            const glm::dvec3 p = random_point(random, 1.1);
            const double distance = sponge.value(p);
            if (std::abs(distance) < 1e-9) continue;
            ASSERT_EQ(distance < 0, is_in_sponge(p, levels))
                << "seed " << seed << ", " << levels << " levels, " << describe(p);
        }
    }
}

TEST(Menger, fills_twenty_of_twenty_seven_at_each_level) {
    constexpr unsigned seed = 13;
    constexpr int points = 6000;
    for (int levels = 0; levels <= 3; ++levels) {
        Random random(seed);
        const Fractal sponge = menger(levels);
        int inside = 0;
        for (int i = 0; i < points; ++i) inside += sponge.value(random_point(random, 1)) < 0;
        const double part = std::pow(20.0 / 27, levels);
        const double deviation = std::sqrt(part * (1 - part) / points);
        EXPECT_NEAR(static_cast<double>(inside) / points, part, 4 * deviation + 1e-12)
            << levels << " levels, seed " << seed;
    }
}

TEST(Menger, has_holes_right_through) {
    const Fractal sponge = menger(3);
    for (const double t : {-0.9, -0.5, 0.0, 0.3, 0.8}) {
        EXPECT_GT(sponge.value({t, 0.1, 0.2}), 0);
        EXPECT_GT(sponge.value({0.1, t, 0.2}), 0);
        EXPECT_GT(sponge.value({0.1, 0.2, t}), 0);
        EXPECT_GT(sponge.value({t, 2.0 / 3, -2.0 / 3}), 0) << "a hole of the second level";
    }
    EXPECT_NEAR(sponge.value({0, 0, 0}), 1.0 / 3, 1e-15) << "to the edge of the large hole";
    EXPECT_LT(sponge.value({0.99, 0.99, 0.99}), 0);
}

}  // namespace
}  // namespace formula
