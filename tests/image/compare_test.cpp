// SPDX-License-Identifier: MIT
// Known differences of small pictures.
#include "image/compare.h"

#include <gtest/gtest.h>

namespace {

using image::Picture;

TEST(Compare, finds_no_difference_between_equal_pictures) {
    Picture a(3, 2);
    a.at(1, 1)[0] = 200;
    const image::Difference d = image::compare(a, a, 0);
    EXPECT_EQ(d.largest, 0);
    EXPECT_EQ(d.mean, 0);
    EXPECT_EQ(d.changed, 0u);
    EXPECT_EQ(d.picture, Picture(3, 2));
}

TEST(Compare, takes_the_largest_channel_of_each_pixel) {
    Picture a(2, 2);
    Picture b(2, 2);
    b.at(0, 0)[0] = 3;
    b.at(0, 0)[2] = 10;
    a.at(1, 1)[1] = 6;
    const image::Difference d = image::compare(a, b, 5);
    EXPECT_EQ(d.largest, 10);
    EXPECT_EQ(d.mean, 4);  // (10 + 6) over four pixels
    EXPECT_EQ(d.changed, 2u);
}

TEST(Compare, counts_only_pixels_above_the_tolerance) {
    Picture a(2, 1);
    Picture b(2, 1);
    b.at(0, 0)[0] = 5;
    b.at(1, 0)[0] = 6;
    EXPECT_EQ(image::compare(a, b, 5).changed, 1u);
    EXPECT_EQ(image::compare(a, b, 6).changed, 0u);
}

TEST(Compare, shows_the_difference_eightfold_and_without_overflow) {
    Picture a(1, 1);
    Picture b(1, 1);
    b.at(0, 0)[0] = 3;
    b.at(0, 0)[1] = 32;
    a.at(0, 0)[2] = 255;
    const image::Difference d = image::compare(a, b, 0);
    EXPECT_EQ(d.picture.values, (std::vector<std::uint8_t>{24, 255, 255}));
}

}  // namespace
