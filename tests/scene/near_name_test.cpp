// SPDX-License-Identifier: MIT
// Mistyped names.
#include "scene/near_name.h"

#include <gtest/gtest.h>

namespace {

const std::vector<std::string> names{"steps", "shadow", "shadows", "epsilon", "up"};

TEST(NearName, finds_one_wrong_left_out_added_or_swapped_letter) {
    EXPECT_EQ(scene::near_name("stops", names), "steps");
    EXPECT_EQ(scene::near_name("step", names), "steps");
    EXPECT_EQ(scene::near_name("epsillon", names), "epsilon");
    EXPECT_EQ(scene::near_name("setps", names), "steps");
    EXPECT_EQ(scene::near_name("Steps", names), "steps");
}

TEST(NearName, takes_the_nearest) {
    EXPECT_EQ(scene::near_name("shadwos", names), "shadows");
    EXPECT_EQ(scene::near_name("shado", names), "shadow");
}

TEST(NearName, is_empty_if_nothing_is_near) {
    EXPECT_EQ(scene::near_name("colour", names), "");
    EXPECT_EQ(scene::near_name("xy", names), "");
    EXPECT_EQ(scene::near_name("", names), "");
    EXPECT_EQ(scene::near_name("steps", {}), "");
}

}  // namespace
