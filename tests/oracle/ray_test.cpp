// SPDX-License-Identifier: MIT
#include "oracle/ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include <glm/geometric.hpp>

#include "render_answers/ray.h"

namespace oracle {
namespace {

using Random = std::mt19937_64;

double in(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}
glm::dvec3 point(Random& random, double size) {
    return {in(random, -size, size), in(random, -size, size), in(random, -size, size)};
}

struct View {
    scene::Camera camera;
    scene::Bounds bounds;
    int width, height;
};
View view(Random& random) {
    View view{{point(random, 4), point(random, 1), point(random, 1), in(random, 5, 120)}, {}, 0, 0};
    view.bounds.shape =
        random() % 2 == 0 ? scene::Bounds::Shape::sphere : scene::Bounds::Shape::box;
    view.bounds.centre = point(random, 1);
    view.bounds.half = glm::dvec3(in(random, 0.2, 3));
    if (view.bounds.shape == scene::Bounds::Shape::box) view.bounds.half.y = in(random, 0.2, 3);
    view.width = 16 + static_cast<int>(random() % 100);
    view.height = 16 + static_cast<int>(random() % 100);
    return view;
}

constexpr std::uint64_t seed = 7;

TEST(Ray, is_that_of_the_contract) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    for (int i = 0; i < 1000; ++i) {
        const View v = view(random);
        const double x = in(random, 0, v.width), y = in(random, 0, v.height);
        const Ray ray = Pinhole(v.camera, v.width, v.height).through(x, y);
        const render_answers::Ray other =
            render_answers::ray_through(v.camera, v.width, v.height, x, y);
        EXPECT_EQ(ray.origin, other.origin);
        EXPECT_LT(glm::distance(ray.direction, other.direction), 1e-14);
    }
}

TEST(Ray, is_in_the_beam_of_its_tile_and_within_the_bounds_where_that_is) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    int met = 0;
    for (int i = 0; i < 300; ++i) {
        const View v = view(random);
        const Pinhole pinhole(v.camera, v.width, v.height);
        const double left = std::floor(in(random, 0, v.width)), size = 1 << random() % 5;
        const double top = std::floor(in(random, 0, v.height));
        const Beam beam = pinhole.through({left, left + size}, {top, top + size});
        const Stretch all = within(v.bounds, beam);
        const double latest = latest_begin(v.bounds, beam);
        for (int k = 0; k < 50; ++k) {
            const Ray ray = pinhole.through(left + in(random, 0, size), top + in(random, 0, size));
            EXPECT_EQ(ray.origin, beam.origin);
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_TRUE(
                    beam.direction[static_cast<std::size_t>(axis)].contains(ray.direction[axis]));
            }
            const auto stretch = within(v.bounds, ray);
            if (!stretch) continue;
            ++met;
            EXPECT_LE(all.begin, stretch->begin);
            EXPECT_GE(all.end, stretch->end);
            EXPECT_LE(stretch->begin, latest);
            // The ends lie in the walls, or at the eye.
            for (const double t : {stretch->begin, stretch->end}) {
                const glm::dvec3 offset = ray.at(t) - v.bounds.centre;
                double wall = glm::length(offset) / v.bounds.half.x;
                if (v.bounds.shape == scene::Bounds::Shape::box) {
                    wall = 0;
                    for (int axis = 0; axis < 3; ++axis) {
                        wall = std::max(wall, std::abs(offset[axis]) / v.bounds.half[axis]);
                    }
                }
                EXPECT_LE(wall, 1 + 1e-9);
                EXPECT_TRUE(t == 0 || wall >= 1 - 1e-9) << wall;
            }
        }
    }
    EXPECT_GT(met, 3000);
}

}  // namespace
}  // namespace oracle
