// SPDX-License-Identifier: MIT
// The rays of a picture's pixels, computed here a second time, independently of the renderer.
#pragma once

#include <glm/vec3.hpp>

#include "scene/camera.h"

namespace render_answers {

/// The points origin + t * direction; the direction is a unit vector.
struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction;

    glm::dvec3 at(double t) const { return origin + t * direction; }
};

/// The ray through a point of the picture, from its left and top in pixels: the centre of pixel (i,
/// j) is (i + 0.5, j + 0.5).
Ray ray_through(const scene::Camera& camera, int width, int height, double x, double y);

}  // namespace render_answers
