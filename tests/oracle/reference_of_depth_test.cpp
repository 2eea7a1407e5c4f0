// SPDX-License-Identifier: MIT
#include "oracle/reference_of_depth.h"

#include <gtest/gtest.h>

#include "oracle/hand_made.h"

namespace {

using hand_made::infinity;
using oracle::Verdict;

image::Grey depths(std::vector<float> values) {
    image::Grey depth(static_cast<int>(values.size()), 1);
    depth.values = std::move(values);
    return depth;
}

TEST(ReferenceOfDepth, takes_depths_at_their_word) {
    const auto reference =
        oracle::reference_of_depth(depths({2, infinity, 0, hand_made::nan, -1}), {}, 90);
    ASSERT_TRUE(reference);
    EXPECT_EQ(reference->at(0, 0).verdict, Verdict::hit);
    EXPECT_EQ(reference->at(0, 0).depth(), 2);
    EXPECT_EQ(reference->at(0, 0).normal, glm::dvec3(0));
    EXPECT_EQ(reference->at(1, 0).verdict, Verdict::miss);
    EXPECT_EQ(reference->at(2, 0).verdict, Verdict::hit);
    EXPECT_EQ(reference->at(3, 0).verdict, Verdict::undecided);
    EXPECT_EQ(reference->at(4, 0).verdict, Verdict::undecided);
    EXPECT_FALSE(reference->at(0, 0).fragile);
}

TEST(ReferenceOfDepth, knows_a_pixels_footprint) {
    image::Grey depth(4, 10);
    const auto reference = oracle::reference_of_depth(depth, {}, 90);
    ASSERT_TRUE(reference);
    EXPECT_NEAR(reference->pixel_width, 0.2, 1e-15);
    EXPECT_EQ(reference->width, 4);
    EXPECT_EQ(reference->height, 10);
}

TEST(ReferenceOfDepth, takes_normals_where_there_is_a_surface) {
    image::Vectors normal(2, 1);
    normal.values = {0, 1, 0, 0, 0, 1};
    const auto reference = oracle::reference_of_depth(depths({2, infinity}), normal, 90);
    ASSERT_TRUE(reference);
    EXPECT_EQ(reference->at(0, 0).normal, glm::dvec3(0, 1, 0));
    EXPECT_EQ(reference->at(1, 0).normal, glm::dvec3(0));
}

TEST(ReferenceOfDepth, refuses_normals_of_another_size) {
    const auto reference = oracle::reference_of_depth(depths({2}), image::Vectors(2, 1), 90);
    ASSERT_FALSE(reference);
    EXPECT_EQ(reference.problems()[0].message,
              "the reference's depth has 1x1 pixels, its normal 2x1; both must be of one picture");
}

}  // namespace
