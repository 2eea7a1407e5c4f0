// SPDX-License-Identifier: MIT
// The pinhole camera's geometry and motion.
#include "scene/camera.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace scene {
namespace {

using glm::dvec3;

/// The bounding sphere keeps this part of the picture's nearer pair of edges free.
constexpr double margin = 0.04;
/// How close to straight above or below `orbit` goes, in radians.
constexpr double pole_distance = 0.01;
constexpr double least_distance = 1e-11;
constexpr double greatest_distance = 1e6;

bool is_finite(const dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double radians(double degrees) { return degrees * (std::acos(-1.0) / 180); }

/// The vector divided by its length, or the other one where it has none.
dvec3 direction_or(const dvec3& v, const dvec3& otherwise) {
    const double length = glm::length(v);
    return std::isfinite(length) && length > 0 ? v / length : otherwise;
}

double half_angle(const Camera& camera) {
    const double fov = std::isfinite(camera.fov) ? camera.fov : Camera{}.fov;
    return radians(std::clamp(fov, least_fov, greatest_fov)) / 2;
}

/// From the target to the eye; something usable where both are one point.
dvec3 arm(const Camera& camera) {
    const dvec3 v = camera.eye - camera.target;
    const double length = glm::length(v);
    return std::isfinite(length) && length > least_distance / 2 ? v : dvec3(0, 0, 1);
}

/// Where the eye stands, so that a sphere of this radius around the target fills the picture.
double framing_distance(double radius, double half, double aspect) {
    if (!(std::isfinite(aspect) && aspect > 0)) aspect = 1;
    // The sphere's silhouette is a cone about the view; its tangent is what the picture shows.
    const double edge = std::tan(half) * std::min(1.0, aspect) * (1 - margin);
    return radius * std::sqrt(1 + edge * edge) / edge;
}

/// The radius of the sphere around the region's centre that holds it.
double bounding_radius(const Bounds& region) {
    return region.shape == Bounds::Shape::box ? glm::length(region.half) : region.half.x;
}

}  // namespace

Bounds framed_region(const Bounds& bounds) {
    return bounds.shape == Bounds::Shape::none ? Bounds{} : bounds;
}

Axes axes(const Camera& camera) {
    constexpr double parallel = 1e-9;
    Axes result{};
    result.w = direction_or(camera.target - camera.eye, dvec3(0, 0, -1));
    for (const dvec3& up : {direction_or(camera.up, dvec3(0)), dvec3(0, 0, 1), dvec3(1, 0, 0)}) {
        result.u = glm::cross(result.w, up);
        if (glm::length(result.u) > parallel) break;
    }
    result.u = glm::normalize(result.u);
    result.v = glm::cross(result.u, result.w);
    return result;
}

Camera frame_all(const Bounds& bounds, double aspect, double fov) {
    const dvec3 centre = framed_region(bounds).centre;
    return frame_from({centre + dvec3(1, 0.8, 1.6), centre, dvec3(0, 1, 0), fov}, bounds, aspect);
}

Camera frame_from(const Camera& camera, const Bounds& bounds, double aspect) {
    const Bounds region = framed_region(bounds);
    const double distance = framing_distance(bounding_radius(region), half_angle(camera), aspect);
    Camera result = camera;
    result.target = region.centre;
    result.eye = region.centre - distance * axes(camera).w;
    return result;
}

Camera orbit(const Camera& camera, double yaw, double pitch) {
    if (!std::isfinite(yaw) || !std::isfinite(pitch) || (yaw == 0 && pitch == 0)) return camera;
    const dvec3 from_target = arm(camera);
    const double distance = glm::length(from_target);
    const dvec3 pole = direction_or(camera.up, dvec3(0, 1, 0));
    const double height = std::clamp(glm::dot(from_target, pole) / distance, -1.0, 1.0);
    // At a pole itself the picture's upward direction says which way the eye comes down.
    const dvec3 at_pole = axes(camera).v * (height > 0 ? -1.0 : 1.0);
    dvec3 outward = from_target / distance - height * pole;
    outward = glm::length(outward) > 1e-9 ? glm::normalize(outward) : at_pole;
    const dvec3 turned = std::cos(yaw) * outward + std::sin(yaw) * glm::cross(pole, outward);
    const double limit = std::acos(0.0) - pole_distance;
    const double elevation = std::clamp(std::asin(height) + pitch, -limit, limit);
    Camera result = camera;
    result.eye =
        camera.target + distance * (std::cos(elevation) * turned + std::sin(elevation) * pole);
    return result;
}

Camera pan(const Camera& camera, double right, double up) {
    const Axes a = axes(camera);
    const double picture_height = 2 * glm::length(arm(camera)) * std::tan(half_angle(camera));
    const dvec3 move = picture_height * (right * a.u + up * a.v);
    if (!is_finite(move)) return camera;
    Camera result = camera;
    result.eye += move;
    result.target += move;
    return result;
}

Camera dolly(const Camera& camera, double factor) {
    if (!std::isfinite(factor) || factor <= 0) return camera;
    const dvec3 from_target = arm(camera);
    const double distance = glm::length(from_target);
    // Far from the origin the least distance must still be one that the eye's coordinates can show.
    const double least = std::max(least_distance, 1e-11 * glm::length(camera.target));
    const double wanted = std::clamp(distance * factor, least, std::max(least, greatest_distance));
    Camera result = camera;
    result.eye = camera.target + from_target * (wanted / distance);
    return result;
}

}  // namespace scene
