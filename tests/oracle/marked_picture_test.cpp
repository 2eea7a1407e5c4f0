// SPDX-License-Identifier: MIT
#include "oracle/marked_picture.h"

#include <set>

#include <gtest/gtest.h>

#include "oracle/hand_made.h"

namespace {

using hand_made::hit;
using hand_made::infinity;
using hand_made::miss;
using oracle::Judgement;
using oracle::Mark;

image::Picture mark(const oracle::Reference& reference, const oracle::Shot& shot) {
    const auto metrics = oracle::compare(reference, shot);
    EXPECT_TRUE(metrics);
    return metrics ? oracle::marked_picture(reference, *metrics) : image::Picture{};
}

Mark pixel(const image::Picture& picture, int x) {
    const std::uint8_t* p = picture.at(x, 0);
    return {p[0], p[1], p[2]};
}

TEST(MarkedPicture, gives_each_judgement_a_colour_of_its_own) {
    std::set<Mark> marks;
    for (const Judgement judgement :
         {Judgement::missed, Judgement::phantom, Judgement::moved, Judgement::excused}) {
        const auto colour = oracle::mark_of(judgement);
        ASSERT_TRUE(colour);
        EXPECT_FALSE((*colour)[0] == (*colour)[1] && (*colour)[1] == (*colour)[2]) << "it is grey";
        marks.insert(*colour);
    }
    EXPECT_EQ(marks.size(), 4u);
    EXPECT_FALSE(oracle::mark_of(Judgement::right));
}

TEST(MarkedPicture, marks_the_pixels_that_are_not_right) {
    const image::Picture picture =
        mark(hand_made::row({hit(1), miss(), hit(1), hand_made::undecided(1, 2), hit(1)}),
             hand_made::shot({infinity, 1, 2, 1, 1}));
    EXPECT_EQ(pixel(picture, 0), oracle::mark_of(Judgement::missed));
    EXPECT_EQ(pixel(picture, 1), oracle::mark_of(Judgement::phantom));
    EXPECT_EQ(pixel(picture, 2), oracle::mark_of(Judgement::moved));
    EXPECT_EQ(pixel(picture, 3), oracle::mark_of(Judgement::excused));
    EXPECT_EQ(pixel(picture, 4), (Mark{224, 224, 224}));
}

TEST(MarkedPicture, shades_near_hits_brighter_than_far_ones_and_those_than_misses) {
    const image::Picture picture = mark(hand_made::row({hit(1), hit(1.5), hit(2), miss()}),
                                        hand_made::shot({1, 1.5, 2, infinity}));
    EXPECT_EQ(pixel(picture, 0), (Mark{224, 224, 224}));
    EXPECT_EQ(pixel(picture, 1), (Mark{144, 144, 144}));
    EXPECT_EQ(pixel(picture, 2), (Mark{64, 64, 64}));
    EXPECT_EQ(pixel(picture, 3), (Mark{24, 24, 24}));
}

TEST(MarkedPicture, has_no_greys_to_spread_where_nothing_is_hit) {
    const image::Picture picture = mark(hand_made::row({miss(), hand_made::undecided(1, infinity)}),
                                        hand_made::shot({infinity, infinity}));
    EXPECT_EQ(pixel(picture, 0), (Mark{24, 24, 24}));
}

}  // namespace
