// SPDX-License-Identifier: MIT
#include "oracle/picture.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "oracle/traced.h"

namespace oracle {
namespace {

using Rgb = std::array<int, 3>;

Rgb at(const image::Picture& picture, int x, int y) {
    return {picture.at(x, y)[0], picture.at(x, y)[1], picture.at(x, y)[2]};
}

/// The middle of a shaded picture from straight above.
Rgb middle(const std::string& formula) {
    Scene scene{.formula = formula, .bounds = {}, .camera = {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 30}};
    scene.width = scene.height = 5;
    const Query query{.width = 5, .height = 5, .region = {}, .progress = {}};
    return at(shaded_picture(traced(scene), understood(formula), scene.document(), query), 2, 2);
}

TEST(Picture, shows_the_own_colours_of_leaves_and_of_cells) {
    for (const char* formula :
         {"colour(sphere(1), (0.1, 0.8, 0.1))",
          "sphere(0.1) | colour(repeat(sphere(0.2), (0.5, 0.5, 0.5)), (0.1, 0.8, 0.1))",
          "repeat(colour(sphere(0.3), (0.1, 0.8 - z, 0.1)), (1, 1, 1))"}) {
        const Rgb colour = middle(formula);
        EXPECT_GT(colour[1], 150) << formula;
        EXPECT_LT(colour[0], 150) << formula;
    }
    EXPECT_GT(middle("sphere(1)")[0], middle("sphere(1)")[2] + 30);
}

TEST(Picture, of_a_certificate_has_a_colour_for_each_verdict) {
    Reference reference;
    reference.width = 4;
    reference.height = 1;
    reference.pixels.resize(4);
    reference.pixels[0].verdict = Verdict::hit;
    reference.pixels[1].verdict = Verdict::miss;
    reference.pixels[2].verdict = Verdict::hit;
    reference.pixels[2].fragile = true;
    reference.pixels[3].verdict = Verdict::undecided;
    const image::Picture proven = certificate_picture(reference);
    for (Pixel& pixel : reference.pixels) pixel.estimated = true;
    const image::Picture guessed = certificate_picture(reference);
    EXPECT_EQ(at(proven, 0, 0), (Rgb{215, 215, 215}));
    EXPECT_EQ(at(proven, 1, 0), (Rgb{25, 35, 80}));
    EXPECT_EQ(at(guessed, 0, 0), (Rgb{235, 130, 40}));
    EXPECT_EQ(at(guessed, 1, 0), (Rgb{75, 45, 30}));
    for (const image::Picture* picture : {&proven, &guessed}) {
        EXPECT_EQ(at(*picture, 2, 0), (Rgb{255, 210, 0}));
        EXPECT_EQ(at(*picture, 3, 0), (Rgb{255, 0, 255}));
    }
}

TEST(Picture, of_depths_is_infinite_for_a_miss) {
    Reference reference;
    reference.width = 2;
    reference.height = 1;
    reference.pixels.resize(2);
    reference.pixels[0] = {Verdict::undecided, false, 0, 2, 3, {0, 0, 1}};
    reference.pixels[1].verdict = Verdict::miss;
    reference.pixels[1].near = reference.pixels[1].far = INFINITY;
    EXPECT_EQ(*depths(reference).at(0, 0), 2.5F);
    EXPECT_EQ(*depths(reference).at(1, 0), INFINITY);
    EXPECT_EQ(normals(reference).at(0, 0)[2], 1);
    EXPECT_EQ(normals(reference).at(1, 0)[2], 0);
}

}  // namespace
}  // namespace oracle
