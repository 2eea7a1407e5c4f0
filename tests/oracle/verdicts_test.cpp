// SPDX-License-Identifier: MIT
// Single rays at what is hard: poles, domains, jumps, even roots.
#include <gtest/gtest.h>

#include <cmath>

#include "oracle/traced.h"

namespace oracle {
namespace {

void expect_hit(const Pixel& pixel, double depth) {
    EXPECT_EQ(pixel.verdict, Verdict::hit);
    EXPECT_LE(pixel.near, depth * (1 + 1e-12));
    EXPECT_GE(pixel.far, depth * (1 - 1e-12));
}

TEST(Verdicts, a_pole_is_no_sheet) {
    for (const char* formula :
         {"1/z = 0", "1/(z - x + 0.1) = 0", "1/z^2 + 1/(z - 0.25)^2 = 0", "tan(z/4) = -9",
          "1/(1 + 1/z) = 1", "z/z = 0", "(z - 9)/(z^2 - 0.01) = 0"}) {
        EXPECT_EQ(down_z(formula).verdict, Verdict::miss) << formula;
    }
    // Between poles and behind them there may be sheets.
    expect_hit(down_z("1/z + 4 = 0"), 5.25);
    expect_hit(down_z("1/(1 + 1/z) = 3"), 6.5);
    expect_hit(down_z("tan(4z) = 1"), 5 - 9 * M_PI / 16);
    expect_hit(down_z("z*(z - 0.5)/z = 0"), 4.5);
}

TEST(Verdicts, a_jump_is_no_sheet) {
    for (const char* formula : {"floor(z) = 0.5", "z - floor(z) = 1.5", "sign(z) = 0.5",
                                "atan2(z, -1 - x^2) = 7", "if(z < 0.3, 1, -1) = 0"}) {
        EXPECT_EQ(down_z(formula).verdict, Verdict::miss) << formula;
    }
    expect_hit(down_z("z - floor(z) = 0.3"), 5 - 1.3);
    expect_hit(down_z("mod(z, 0.75) = 0.2"), 5 - 1.7);
}

TEST(Verdicts, a_jump_or_a_pole_of_a_solid_is_its_wall) {
    expect_hit(down_z("floor(z) <= 0.5"), 4);
    expect_hit(down_z("1/(z - 0.25) <= 0"), 4.75);
}

TEST(Verdicts, outside_of_the_domain_is_outside) {
    expect_hit(down_z("sqrt(0.5 - z) <= 10"), 4.5);
    expect_hit(down_z("log(0.5 - z) <= 10"), 4.5);
    EXPECT_EQ(down_z("sqrt(z^2 - 9) <= 10").verdict, Verdict::miss);
}

TEST(Verdicts, an_even_root_that_is_written_as_one_is_hit) {
    for (const char* formula :
         {"(z - 0.25)^2 = 0", "abs(z - 0.25) = 0", "-3(z - 0.25)^4 = 0", "sqrt(abs(z - 0.25)) = 0",
          "abs(4z - 1)^1.5 = 0", "cbrt((z - 0.25)^2) = 0", "exp(x)*(z - 0.25)^2 = 0",
          "log(z + 0.75)^2 = 0", "sqrt(0.25 - z) = 0", "(z - 0.25)^2*(z + 1) = 0"}) {
        expect_hit(down_z(formula), 4.75);
    }
    expect_hit(down_z("(x^2 + y^2 + z^2 - 1)^2 = 0"), 4);
}

TEST(Verdicts, an_escape_time_set_cuts_a_sheet) {
    for (const char* set : {"julia(c = (0, 0, 0, 0))", "mandelbulb(8, 3)"}) {
        const std::string text = std::string("z = 0.1 & ") + set;
        const Pixel within = down_z(text, 0.3, 0.2);
        EXPECT_EQ(within.verdict, Verdict::hit) << text;
        EXPECT_NEAR(within.depth(), 4.9, 1e-8) << text;
        EXPECT_EQ(down_z(text, 1.5, 0.2).verdict, Verdict::miss) << text;
    }
}

TEST(Verdicts, a_sheet_may_be_a_solid) {
    expect_hit(down_z("max(x^2 + y^2 + z^2 - 1, 0) = 0"), 4);
    expect_hit(down_z("min(0, 1 - x^2 - y^2 - z^2) = 0"), 4);
    EXPECT_EQ(down_z("max(x^2 + y^2 + z^2 - 1, 0) = 0", 1.1).verdict, Verdict::miss);
}

TEST(Verdicts, another_even_root_is_undecided_about_where_it_is) {
    const Pixel pixel = down_z("z^2 - z + 0.25 = 0");
    EXPECT_EQ(pixel.verdict, Verdict::undecided);
    EXPECT_LT(pixel.near, 4.5);
    EXPECT_GT(pixel.far, 4.5);
    EXPECT_NEAR(pixel.depth(), 4.5, 1e-6);
    EXPECT_EQ(pixel.normal, glm::dvec3(0, 0, 1));
}

TEST(Verdicts, a_tangent_ray_is_undecided) {
    const Pixel pixel = down_z("x^2 + y^2 + z^2 = 1", 1);
    EXPECT_EQ(pixel.verdict, Verdict::undecided);
    EXPECT_NEAR(pixel.depth(), 5, 1e-6);
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
