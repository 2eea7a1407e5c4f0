// SPDX-License-Identifier: MIT
// Iterations whose set after so many turns is known.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace render_answers
