// SPDX-License-Identifier: MIT
#include "formula/suggest.h"

#include <gtest/gtest.h>

#include "formula/built_in.h"

namespace formula {
namespace {

TEST(Suggest, finds_the_name_that_was_meant) {
    const std::vector<std::string_view> names = built_in_names();
    EXPECT_EQ(nearest("sine", names), "sin");
    EXPECT_EQ(nearest("Sin", names), "sin");
    EXPECT_EQ(nearest("X", names), "x");
    EXPECT_EQ(nearest("PI", names), "pi");
    EXPECT_EQ(nearest("shpere", names), "sphere");
    EXPECT_EQ(nearest("mandelblub", names), "mandelbulb");
    EXPECT_EQ(nearest("ln", names), "log");
    EXPECT_EQ(nearest("arctan", names), "atan");
    EXPECT_EQ(nearest("smoothunion", names), "smooth_union");
}

TEST(Suggest, finds_nothing_for_names_that_are_far_away_or_short) {
    const std::vector<std::string_view> names = built_in_names();
    EXPECT_EQ(nearest("foo", names), "");
    EXPECT_EQ(nearest("a", names), "");
    EXPECT_EQ(nearest("zz", names), "");
    EXPECT_EQ(nearest("dodecahedron", names), "");
}

}  // namespace
}  // namespace formula
