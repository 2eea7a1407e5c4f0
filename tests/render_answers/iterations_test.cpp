// SPDX-License-Identifier: MIT
// Iterations whose set after so many turns is known.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <glm/common.hpp>

#include "render_answers/shot.h"

namespace render_answers {
namespace {

// Of q^2 alone |q| is squared at each turn, so that what has not passed 4 after n turns is a ball.
// The loop is written for two turns at once, so odd numbers end in the middle.
TEST(Iterations, end_after_the_turns_that_were_asked_for) {
    for (int turns = 1; turns <= 7; ++turns) {
        const double radius = std::pow(4.0, std::pow(2.0, -turns));
        const render::Still still = render({fmt::format("julia((0, 0, 0, 0), {})", turns),
                                            sphere_bounds(2.5),
                                            camera({0, 0, 6}, {0, 0, 0}, 1),
                                            {},
                                            9,
                                            9});
        ASSERT_EQ(status(still, 4, 4), shader::Status::hit) << turns << " turns";
        EXPECT_NEAR(depth(still, 4, 4), 6 - radius, 2e-3) << turns << " turns";
    }
}

// The same by a text that is too long for two turns at once.
TEST(Iterations, of_many_operations_end_after_the_turns_that_were_asked_for) {
    for (int turns = 1; turns <= 4; ++turns) {
        const double radius = std::pow(4.0, std::pow(8.0, -turns));
        const render::Still still =
            render({fmt::format("iterate q = quaternion(x, y, z, 0) for {} until length(q) > 4:\n"
                                "    q = q^8",
                                turns),
                    sphere_bounds(2.5),
                    camera({0, 0, 6}, {0, 0, 0}, 1),
                    {},
                    9,
                    9});
        ASSERT_EQ(status(still, 4, 4), shader::Status::hit) << turns << " turns";
        EXPECT_NEAR(depth(still, 4, 4), 6 - radius, 2e-3) << turns << " turns";
    }
}

// Each wall of the sponge lies across an axis; a normal by differences is bent within a pixel of
// each of its many edges.
TEST(Iterations, that_carry_their_gradient_have_the_normals_of_their_walls) {
    const render::Still still =
        render({"menger(3)", box_bounds({1.01, 1.01, 1.01}), camera({2.6, 2.1, 3.9}), {}, 80, 60});
    int hits = 0, bent = 0;
    for (int j = 0; j < 60; ++j) {
        for (int i = 0; i < 80; ++i) {
            if (status(still, i, j) != shader::Status::hit) continue;
            const glm::dvec3 n = abs(normal(still, i, j));
            ++hits;
            bent += std::max({n.x, n.y, n.z}) < 0.999999;
        }
    }
    EXPECT_GT(hits, 1000);
    // On the outer edges, from where the cube's distance is to an edge.
    EXPECT_LE(bent, hits / 100);
}

}  // namespace
}  // namespace render_answers
