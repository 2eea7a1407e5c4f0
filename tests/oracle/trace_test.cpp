// SPDX-License-Identifier: MIT
#include "oracle/trace.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <optional>
#include <string>

#include "oracle/reference_file.h"
#include "oracle/traced.h"

namespace oracle {
namespace {

const Scene ball{.formula = "(x^2 + y^2 + z^2 = 1) | box(1.2, 0.2, 0.3)"};

std::string problem_of(const Query& query) {
    const auto reference = trace(understood(ball.formula), ball.document(), query);
    return reference ? "" : reference.problems().front().message;
}

TEST(Trace, gives_the_same_bytes_on_any_number_of_threads) {
    EXPECT_EQ(to_bytes(traced(ball, 1)), to_bytes(traced(ball, 3)));
}

TEST(Trace, makes_a_region_as_a_crop_of_the_whole) {
    const Reference whole = traced(ball);
    Query query{.width = ball.width,
                .height = ball.height,
                .region = std::array{5, 4, 9, 7},
                .threads = 2,
                .progress = {}};
    const auto part = trace(understood(ball.formula), ball.document(), query);
    ASSERT_TRUE(part);
    ASSERT_EQ(part->pixels.size(), 63U);
    for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < 9; ++x) {
            const Pixel &a = part->at(x, y), &b = whole.at(5 + x, 4 + y);
            EXPECT_EQ(a.near, b.near);
            EXPECT_EQ(a.far, b.far);
            EXPECT_EQ(a.fragile, b.fragile);
            EXPECT_EQ(a.object, b.object);
        }
    }
}

TEST(Trace, marks_a_pixel_at_an_outline_as_fragile) {
    // The edge of the box is 0.01 pixel beside the centre of the only pixel, then 0.2.
    Scene scene{.formula = "x <= 0", .bounds = {}, .camera = {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 10}};
    scene.width = scene.height = 21;
    scene.bounds = {scene::Bounds::Shape::box, glm::dvec3(0), glm::dvec3(0.4)};
    const double pixel = traced(scene).pixel_width * 4.6;
    for (const auto& [offset, fragile] : {std::pair{0.01, true}, std::pair{0.2, false}}) {
        scene.formula = "x <= " + std::to_string(offset * pixel);
        EXPECT_EQ(traced(scene).at(10, 10).fragile, fragile) << offset;
        EXPECT_FALSE(traced(scene).at(3, 10).fragile);
    }
}

TEST(Trace, refuses_sizes_and_regions_that_make_no_sense) {
    EXPECT_EQ(problem_of({.width = 0, .height = 10, .region = {}, .progress = {}}),
              "a reference of 0x10 pixels is out of range; width and height go from 1 to 32768");
    EXPECT_EQ(
        problem_of({.width = 20, .height = 10, .region = std::array{15, 0, 6, 10}, .progress = {}}),
        "the region 15,0,6,10 is not inside of the picture of 20x10 pixels; choose a part of "
        "it");
}

TEST(Trace, tells_its_progress_and_can_be_given_up) {
    std::atomic<int> calls{0};
    Query query{.width = 64, .height = 48, .region = {}, .threads = 2, .progress = {}};
    query.progress = [&](double fraction) {
        EXPECT_GT(fraction, 0);
        EXPECT_LE(fraction, 1);
        return ++calls < 5;
    };
    EXPECT_EQ(problem_of(query), "the reference was given up; ask for it again");
    EXPECT_GE(calls, 5);
    EXPECT_LE(calls, 6);  // the other thread may have been about to tell
}

}  // namespace
}  // namespace oracle
