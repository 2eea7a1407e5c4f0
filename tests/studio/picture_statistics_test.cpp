// SPDX-License-Identifier: MIT
// Counting the pixels of a picture.
#include "studio/picture_statistics.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

TEST(PictureStatistics, counts_steps_and_endings) {
    image::Image<float, 4> geometry(2, 2);
    // Depth, steps, status, object.
    geometry.values = {1.0f,     4,  1, 0,  INFINITY, 2,  0, -1,  //
                       INFINITY, 10, 0, -1, 3.0f,     32, 2, 0};
    const studio::PictureStatistics expected{
        .mean_steps = 12, .most_steps = 32, .hit = 1, .missed = 2, .unresolved = 1};
    EXPECT_EQ(studio::statistics(geometry), expected);
}

TEST(PictureStatistics, counts_what_is_guessed) {
    image::Image<float, 4> normal(3, 2);
    for (int i = 0; i < 6; ++i) normal.at(i % 3, i / 3)[3] = static_cast<float>(8 * 100 + i);
    EXPECT_EQ(studio::guessed(normal), 2u);
    EXPECT_EQ(studio::guessed({}), 0u);
}

TEST(PictureStatistics, of_no_pixels_are_nothing) {
    EXPECT_EQ(studio::statistics({}), studio::PictureStatistics{});
}

}  // namespace
