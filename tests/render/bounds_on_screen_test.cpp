// SPDX-License-Identifier: MIT
// The parts of the screen around the bounds, against the rays of single pixels.
#include "render/bounds_on_screen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "scene/camera.h"

namespace {

using render::Frame;
using render::Tile;

/// As shaders/common/ray.glsl does it.
glm::dvec3 direction(const Frame& frame, int i, int j) {
    const glm::dvec2 pixel(std::floor((i + 0.5) * frame.passes.y) + frame.picture.z + 0.5,
                           std::floor((j + 0.5) * frame.passes.z) + frame.picture.w + 0.5);
    const double x = 2 * pixel.x / frame.picture.x - 1, y = 1 - 2 * pixel.y / frame.picture.y;
    return glm::normalize(glm::dvec3(frame.forward) +
                          frame.eye.w * x * frame.picture.x / frame.picture.y *
                              glm::dvec3(frame.right) +
                          frame.eye.w * y * glm::dvec3(frame.up));
}

bool meets_sphere(const Frame& frame, glm::dvec3 d) {
    const glm::dvec3 c = glm::dvec3(frame.bounds_centre) - glm::dvec3(frame.eye);
    const double along = glm::dot(c, d);
    const glm::dvec3 aside = c - along * d;
    const double square = frame.bounds_half.x * frame.bounds_half.x - glm::dot(aside, aside);
    return square > 0 && along + std::sqrt(square) > 0;
}

bool meets_box(const Frame& frame, glm::dvec3 d) {
    double first = 0, last = INFINITY;
    for (int k = 0; k < 3; ++k) {
        const double middle = (frame.bounds_centre[k] - frame.eye[k]) / d[k];
        const double half = std::abs(frame.bounds_half[k] / d[k]);
        first = std::max(first, middle - half);
        last = std::min(last, middle + half);
    }
    return first < last;
}

bool contains(const Tile& tile, int i, int j) {
    return i >= tile.x && i < tile.x + tile.width && j >= tile.y && j < tile.y + tile.height;
}

class BoundsOnScreen : public testing::TestWithParam<bool> {};

TEST_P(BoundsOnScreen, leave_out_no_ray_that_meets_them) {
    const bool box = GetParam();
    constexpr unsigned seed = 20261122;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    const auto point = [&](double size) {
        return size * glm::dvec3(any(random), any(random), any(random));
    };
    int outside = 0, met = 0;
    for (int run = 0; run < 300; ++run) {
        scene::Document document;
        document.bounds.shape = box ? scene::Bounds::Shape::box : scene::Bounds::Shape::sphere;
        document.bounds.centre = point(2);
        document.bounds.half =
            box ? glm::abs(point(1.5)) + 0.05 : glm::dvec3(0.1 + std::abs(any(random)));
        scene::Camera camera;
        camera.eye = point(5);
        camera.target = document.bounds.centre + point(run % 3 == 0 ? 4 : 0.5);
        camera.up = glm::dvec3(0.1, 1, 0.2);
        camera.fov = 40 + 30 * any(random);
        // A part of a picture, and a coarser one than is kept.
        Frame frame = render::frame(document, camera, {160, 120, 7 * (run % 2), 5, 100, 100});
        frame.passes = {0, 1 + run % 2, 1 + run % 2, 0};
        const Tile tile{3, 4, 70, 50};
        const render::ScreenParts parts = bounds_on_screen(frame, box, tile);
        for (int j = 0; j < 60; ++j) {
            for (int i = 0; i < 80; ++i) {
                const auto in = [&](const Tile& part) { return contains(part, i, j); };
                const auto inside = std::ranges::count_if(parts.inside, in);
                const auto around = std::ranges::count_if(parts.outside, in);
                ASSERT_EQ(inside + around, contains(tile, i, j) ? 1 : 0) << i << ", " << j;
                const glm::dvec3 d = direction(frame, i, j);
                const bool meets = box ? meets_box(frame, d) : meets_sphere(frame, d);
                if (around) {
                    ASSERT_FALSE(meets) << "run " << run << ": " << i << ", " << j;
                }
                outside += static_cast<int>(around);
                met += meets && inside;
            }
        }
    }
    EXPECT_GT(outside, 100'000) << "nothing would be gained";
    EXPECT_GT(met, 10'000);
}

INSTANTIATE_TEST_SUITE_P(Shapes, BoundsOnScreen, testing::Bool(),
                         [](const auto& shape) { return shape.param ? "box" : "sphere"; });

}  // namespace
