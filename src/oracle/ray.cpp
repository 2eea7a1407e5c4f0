// SPDX-License-Identifier: MIT
#include "oracle/ray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

namespace oracle {
namespace {

/// Rounding decides nothing about what lies in the wall of the bounds: it is within.
constexpr double wall = 1e-12;

std::optional<Stretch> ahead(double begin, double end) {
    begin = std::max(begin, 0.0);
    if (!(begin < end)) return std::nullopt;
    return Stretch{begin * (1 - wall), end * (1 + wall)};
}

std::optional<Stretch> within_sphere(const scene::Bounds& bounds, const Ray& ray) {
    const glm::dvec3 centre = bounds.centre - ray.origin;
    const double along = glm::dot(centre, ray.direction);
    const glm::dvec3 aside = centre - along * ray.direction;  // b^2 - c would cancel far away
    const double square = bounds.half.x * bounds.half.x - glm::dot(aside, aside);
    if (!(square > 0)) return std::nullopt;
    const double reach = std::sqrt(square);
    return ahead(along - reach, along + reach);
}

std::optional<Stretch> within_box(const scene::Bounds& bounds, const Ray& ray) {
    double begin = 0, end = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const double centre = bounds.centre[i] - ray.origin[i], rate = ray.direction[i];
        if (rate == 0) {
            if (std::abs(centre) > bounds.half[i]) return std::nullopt;
            continue;
        }
        const double middle = centre / rate, reach = bounds.half[i] / std::abs(rate);
        begin = std::max(begin, middle - reach);
        end = std::min(end, middle + reach);
    }
    return ahead(begin, end);
}

}  // namespace

Pinhole::Pinhole(const scene::Camera& camera, int width, int height)
    : eye_(camera.eye),
      axes_(scene::axes(camera)),
      slope_(std::tan(camera.fov * std::numbers::pi / 360)),
      width_(width),
      height_(height) {}

Ray Pinhole::through(double x, double y) const {
    const double right = slope_ * (2 * x / width_ - 1) * (width_ / height_);
    const double up = slope_ * (1 - 2 * y / height_);
    return {eye_, glm::normalize(axes_.w + right * axes_.u + up * axes_.v)};
}

Beam Pinhole::through(numeric::Interval x, numeric::Interval y) const {
    using numeric::Interval;
    const Interval right = slope_ * (2.0 * x / width_ - 1.0) * (width_ / height_);
    const Interval up = slope_ * (1.0 - 2.0 * y / height_);
    const Interval length = sqrt(1.0 + square(right) + square(up));
    Beam beam;
    beam.origin = eye_;
    for (int i = 0; i < 3; ++i) {
        const Interval part = (axes_.w[i] + right * axes_.u[i] + up * axes_.v[i]) / length;
        // Far more than the rounding of a ray's direction, whose numbers are at most 1.
        beam.direction[static_cast<std::size_t>(i)] = part + Interval{-1e-14, 1e-14};
    }
    return beam;
}

std::optional<Stretch> within(const scene::Bounds& bounds, const Ray& ray) {
    switch (bounds.shape) {
        case scene::Bounds::Shape::sphere:
            return within_sphere(bounds, ray);
        case scene::Bounds::Shape::box:
            return within_box(bounds, ray);
        case scene::Bounds::Shape::none:
            break;
    }
    return Stretch{0, scene::far_distance};
}

Stretch within(const scene::Bounds& bounds, const Beam& beam) {
    if (bounds.shape == scene::Bounds::Shape::none) return {0, scene::far_distance};
    // All points of the bounds are as far from the eye as their ball is.
    const double radius =
        bounds.shape == scene::Bounds::Shape::sphere ? bounds.half.x : glm::length(bounds.half);
    const double distance = glm::distance(beam.origin, bounds.centre);
    const double margin = 2 * wall * (distance + radius);
    return {std::max(0.0, distance - radius - margin), distance + radius + margin};
}

double latest_begin(const scene::Bounds& bounds, const Beam& beam) {
    using numeric::Interval;
    if (bounds.shape == scene::Bounds::Shape::none) return 0;
    const glm::dvec3 centre = bounds.centre - beam.origin;
    const auto& d = beam.direction;
    constexpr double slack = 1 + 1e-12;
    if (bounds.shape == scene::Bounds::Shape::sphere) {
        const Interval along = centre.x * d[0] + centre.y * d[1] + centre.z * d[2];
        Interval aside(0.0);
        for (int i = 0; i < 3; ++i) {
            aside = aside + square(centre[i] - along * d[static_cast<std::size_t>(i)]);
        }
        const Interval reach = sqrt(square(Interval(bounds.half.x)) - aside);
        const double begin = reach.is_empty() || reach.partial ? along.hi : (along - reach).hi;
        return std::max(begin, 0.0) * slack;
    }
    double begin = 0;
    for (int i = 0; i < 3; ++i) {
        const Interval rate = d[static_cast<std::size_t>(i)];
        if (rate.contains(0)) return std::numeric_limits<double>::infinity();
        const Interval enter = (centre[i] - bounds.half[i] * sign(rate)) / rate;
        begin = std::max(begin, enter.hi);
    }
    return begin * slack;
}

glm::dvec3 wall_normal(const scene::Bounds& bounds, glm::dvec3 point) {
    const glm::dvec3 offset = point - bounds.centre;
    if (bounds.shape == scene::Bounds::Shape::sphere) return glm::normalize(offset);
    if (bounds.shape == scene::Bounds::Shape::none) return glm::dvec3(0);
    const glm::dvec3 part = offset / bounds.half;
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
        if (std::abs(part[i]) > std::abs(part[axis])) axis = i;
    }
    glm::dvec3 normal(0);
    normal[axis] = part[axis] < 0 ? -1 : 1;
    return normal;
}

}  // namespace oracle
