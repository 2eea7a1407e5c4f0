// SPDX-License-Identifier: MIT
// From a document to the numbers of the uniform block.
#include "render/frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace render {

namespace {

/// Where the ground grid lies when there are no bounds to stand on it.
constexpr double grid_without_bounds = -2;

glm::dvec4 pack(const glm::dvec3& xyz, double w) { return {xyz, w}; }

// The farthest that a ray from the eye can still be within the bounds. A little is added, so that
// rounding to float never cuts the far wall off.
double end_of_rays(const scene::Bounds& bounds, const glm::dvec3& eye) {
    constexpr double slack = 1 + 1e-5;
    const double to_centre = glm::distance(eye, bounds.centre);
    switch (bounds.shape) {
        case scene::Bounds::Shape::sphere:
            return (to_centre + bounds.half.x) * slack;
        case scene::Bounds::Shape::box:
            return (to_centre + glm::length(bounds.half)) * slack;
        case scene::Bounds::Shape::none:
            break;
    }
    return scene::far_distance;
}

double grid_height(const scene::Bounds& bounds) {
    if (bounds.shape == scene::Bounds::Shape::none) return grid_without_bounds;
    return bounds.centre.y - bounds.half.y;
}

glm::dvec3 unit_or_zero(const glm::dvec3& direction) {
    const double length = glm::length(direction);
    return length > 0 ? direction / length : glm::dvec3(0);
}

void set_lights(Frame& frame, const std::vector<scene::Light>& lights) {
    const std::size_t count = std::min(lights.size(), max_lights);
    frame.sky.w = static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
        frame.light_direction[i] = pack(unit_or_zero(lights[i].direction), 0);
        frame.light_colour[i] = pack(lights[i].colour * lights[i].intensity, 0);
    }
}

// Objects take the material of their number modulo the count, so there is always at least one.
void set_materials(Frame& frame, std::vector<scene::Material> materials) {
    if (materials.empty()) materials.emplace_back();
    const std::size_t count = std::min(materials.size(), max_materials);
    frame.ground.w = static_cast<double>(count);
    for (std::size_t i = 0; i < max_materials; ++i) {
        const scene::Material& material = materials[i % count];
        frame.material[i] = pack(material.colour, material.specular);
        frame.material_shininess[i] = pack({material.shininess, 0, 0}, 0);
    }
}

}  // namespace

View whole(int width, int height) { return {width, height, 0, 0, width, height}; }

Frame frame(const scene::Document& document, const scene::Camera& camera, const View& view) {
    const scene::Axes axes = scene::axes(camera);
    const scene::Bounds& bounds = document.bounds;
    const scene::Settings& settings = document.settings;
    const scene::Environment& around = document.environment;

    Frame frame{};
    frame.eye = pack(camera.eye, std::tan(camera.fov * std::numbers::pi / 360));
    frame.right = pack(axes.u, 2.0 * std::tan(camera.fov * std::numbers::pi / 360) / view.height);
    frame.up = pack(axes.v, 1 / settings.lipschitz);
    frame.forward = pack(axes.w, glm::length(bounds.half) / 64);
    frame.origin.w =
        std::min(1.0, glm::distance(camera.eye, camera.target) / glm::length(bounds.half));
    frame.picture = glm::dvec4(view.width, view.height, view.x, view.y);
    frame.bounds_centre = pack(bounds.centre, end_of_rays(bounds, camera.eye));
    frame.bounds_half = pack(bounds.half, grid_height(bounds));
    frame.march = {settings.steps, settings.lipschitz, settings.epsilon, settings.shadow};
    frame.sky = pack(around.sky, 0);
    frame.ground = pack(around.ground, 0);
    frame.background_top = pack(around.background_top, settings.exposure);
    frame.background_bottom = pack(around.background_bottom, 0);
    set_lights(frame, document.lights);
    set_materials(frame, document.materials);
    return frame;
}

Frame about(Frame frame, const std::array<double, 3>& origin) {
    const glm::dvec4 move(origin[0], origin[1], origin[2], 0);
    frame.eye -= move;
    frame.bounds_centre -= move;
    frame.bounds_half.w -= origin[1];
    frame.origin = {origin[0], origin[1], origin[2], frame.origin.w};
    return frame;
}

}  // namespace render
