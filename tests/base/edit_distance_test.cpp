// SPDX-License-Identifier: MIT
#include "base/edit_distance.h"

#include <gtest/gtest.h>

namespace {

using base::edit_distance;

TEST(EditDistance, counts_edits) {
    EXPECT_EQ(edit_distance("", "abc"), 3u);
    EXPECT_EQ(edit_distance("sine", "sin"), 1u);
    EXPECT_EQ(edit_distance("sine", "sinh"), 1u);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
    EXPECT_EQ(edit_distance("abc", "abc"), 0u);
}

TEST(EditDistance, counts_swapped_neighbours_once) {
    EXPECT_EQ(edit_distance("shpere", "sphere"), 1u);
}

TEST(EditDistance, takes_capitals_for_small_letters) { EXPECT_EQ(edit_distance("Sin", "sIN"), 0u); }

}  // namespace
