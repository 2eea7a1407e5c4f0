// SPDX-License-Identifier: MIT
// Single rays at what is hard: poles, domains, jumps, even roots.
#include <gtest/gtest.h>

#include "oracle/traced.h"

namespace oracle {
namespace {

void expect_hit(const Pixel& pixel, double depth) {
    EXPECT_EQ(pixel.verdict, Verdict::hit);
    EXPECT_LE(pixel.near, depth * (1 + 1e-12));
    EXPECT_GE(pixel.far, depth * (1 - 1e-12));
}

TEST(Verdicts, a_pole_is_no_sheet) {
    EXPECT_NE(down_z("1/z = 0").verdict, Verdict::hit);
    EXPECT_NE(down_z("1/(z - x + 0.1) = 0").verdict, Verdict::hit);
}

TEST(Verdicts, a_jump_is_no_sheet) { EXPECT_NE(down_z("floor(z) = 0.5").verdict, Verdict::hit); }

TEST(Verdicts, a_jump_or_a_pole_of_a_solid_is_its_wall) {
    expect_hit(down_z("floor(z) <= 0.5"), 4);
    expect_hit(down_z("1/(z - 0.25) <= 0"), 4.75);
}

TEST(Verdicts, outside_of_the_domain_is_outside) {
    expect_hit(down_z("sqrt(0.5 - z) <= 10"), 4.5);
    expect_hit(down_z("log(0.5 - z) <= 10"), 4.5);
    EXPECT_EQ(down_z("sqrt(z^2 - 9) <= 10").verdict, Verdict::miss);
}

TEST(Verdicts, an_even_root_is_never_a_miss) {
    for (const char* formula :
         {"(z - 0.25)^2 = 0", "z^2 - z + 0.25 = 0", "abs(z) = 0", "(x^2 + y^2 + z^2 - 1)^2 = 0"}) {
        EXPECT_NE(down_z(formula).verdict, Verdict::miss) << formula;
    }
}

TEST(Verdicts, a_bare_miss_of_a_double_root_is_proven) {
    EXPECT_EQ(down_z("z^2 + 1e-9 = 0").verdict, Verdict::miss);
    expect_hit(down_z("z^2 = 1e-8"), 5 - 1e-4);
}

TEST(Verdicts, the_object_is_the_leaf_from_left_to_right) {
    const std::string two = "sphere(0.5) | (translate(sphere(0.5), (0, 0, 1)) & (x <= 3))";
    EXPECT_EQ(down_z(two).object, 1);
    EXPECT_EQ(down_z("(z = -1) | sphere(0.5)").object, 1);
    EXPECT_EQ(down_z("(z = -1) | sphere(0.5)", 0.6).object, 0);
}

}  // namespace
}  // namespace oracle
