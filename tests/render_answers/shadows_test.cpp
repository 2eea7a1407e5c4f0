// SPDX-License-Identifier: MIT
// Penumbrae whose brightness is known point by point.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ray.h"
#include "shot.h"

namespace render_answers {
namespace {

constexpr double radius = 0.5, floor_height = -1, softness = 4, brightness = 0.8;

/// A ball, written as a quartic, above a floor; the light comes from straight above.
scene::Document ball_above_floor() {
    Query query;
    query.formula = "(x^2 + y^2 + z^2)^2 <= 0.5^4 | y <= -1";
    query.bounds = sphere_bounds(2.5);
    query.camera = camera({0, 2, 4}, {0, -0.8, 0}, 40);
    query.settings.shadow = softness;
    scene::Document document = document_of(query);
    document.environment.sky = document.environment.ground = glm::dvec3(0);
    document.materials = {{.colour = glm::dvec3(1), .specular = 0, .shininess = 1}};
    document.lights = {{.direction = {0, 1, 0}, .colour = glm::dvec3(1), .intensity = brightness}};
    return document;
}

/// From a display's byte to linear light (IEC 61966-2-1).
double linear(std::uint8_t byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// How much of the light a point of the floor sees, so far from the axis: by the first-order
/// distance from the ball's quartic where the light's ray comes nearest, which is at its equator.
double seen(double aside) {
    if (aside <= radius) return 0;
    const double distance = (std::pow(aside, 4) - std::pow(radius, 4)) / (4 * std::pow(aside, 3));
    const double part = std::clamp(softness * distance / -floor_height, 0.0, 1.0);
    return part * part * (3 - 2 * part);
}

// Between two of its steps a ray has passed the ball by; how near that was must not be guessed.
// Where a point sees nearly all of the light, the floor is nearer than the ball until it is passed
// by, and nothing tells that it was. A part of a large picture: rays begin some pixels off the
// floor.
TEST(Shadows, fall_off_as_the_nearest_approach_does) {
    const scene::Document document = ball_above_floor();
    constexpr render::View view{1600, 1200, 400, 600, 160, 120};
    const render::Still still = render(document, view, {.picture = true, .geometry = true});
    ASSERT_EQ(still.picture.width, view.region_width);
    int penumbra = 0;
    for (int j = 0; j < view.region_height; ++j) {
        for (int i = 0; i < view.region_width; ++i) {
            if (status(still, i, j) != shader::Status::hit) continue;
            const Ray ray = ray_through(*document.camera, view.width, view.height, view.x + i + 0.5,
                                        view.y + j + 0.5);
            const glm::dvec3 p = ray.at(depth(still, i, j));
            const double part = seen(std::hypot(p.x, p.z));
            if (std::abs(p.y - floor_height) > 1e-3 || part > 0.7) continue;
            penumbra += part > 0.05;
            EXPECT_NEAR(linear(*still.picture.at(i, j)) / brightness, part, 0.05)
                << "at " << p.x << ", " << p.z;
        }
    }
    EXPECT_GT(penumbra, 300);
}

}  // namespace
}  // namespace render_answers
