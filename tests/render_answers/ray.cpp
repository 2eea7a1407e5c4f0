// SPDX-License-Identifier: MIT
#include "render_answers/ray.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace render_answers {

Ray ray_through(const scene::Camera& camera, int width, int height, double x, double y) {
    const glm::dvec3 w = glm::normalize(camera.target - camera.eye);
    glm::dvec3 right = glm::cross(w, camera.up);
    if (glm::length(right) < 1e-9) right = glm::cross(w, glm::dvec3(0, 0, 1));
    if (glm::length(right) < 1e-9) right = glm::cross(w, glm::dvec3(1, 0, 0));
    const glm::dvec3 u = glm::normalize(right);
    const glm::dvec3 v = glm::cross(u, w);
    const double k = std::tan(camera.fov * std::numbers::pi / 360);
    const double across = k * (2 * x / width - 1) * width / height;
    const double above = k * (1 - 2 * y / height);
    return {camera.eye, glm::normalize(w + across * u + above * v)};
}

}  // namespace render_answers
