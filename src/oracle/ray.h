// SPDX-License-Identifier: MIT
// The rays of a picture's pixels, and the part of each that is looked at.
#pragma once

#include <array>
#include <optional>

#include <glm/vec3.hpp>

#include "numeric/interval.h"
#include "scene/camera.h"

namespace oracle {

/// World coordinates; the direction is of unit length up to rounding.
struct Ray {
    glm::dvec3 origin{0};
    glm::dvec3 direction{0, 0, -1};

    glm::dvec3 at(double t) const { return origin + t * direction; }
};

/// All rays from one point whose directions are in a box.
struct Beam {
    glm::dvec3 origin{0};
    std::array<numeric::Interval, 3> direction;

    Beam() = default;
    Beam(const Ray& ray)
        : origin(ray.origin), direction{ray.direction.x, ray.direction.y, ray.direction.z} {}
};

/// A pinhole camera's rays through a picture.
class Pinhole {
public:
    Pinhole(const scene::Camera& camera, int width, int height);

    /// Through a place of the picture in pixels from the left and the top; the centre of the first
    /// pixel is (0.5, 0.5).
    Ray through(double x, double y) const;
    /// Holds all rays through a rectangle of such places, as they are rounded.
    Beam through(numeric::Interval x, numeric::Interval y) const;
    /// A pixel's footprint at distance 1.
    double pixel_width() const { return 2 * slope_ / height_; }

private:
    glm::dvec3 eye_;
    scene::Axes axes_;
    double slope_;  ///< tan(fov / 2)
    double width_, height_;
};

/// A part of a ray, 0 <= begin < end.
struct Stretch {
    double begin = 0;
    double end = 0;
};

/// The part within the bounds with their walls, by 1e-12 longer than it is; without bounds up to
/// scene::far_distance.
std::optional<Stretch> within(const scene::Bounds& bounds, const Ray& ray);

/// Holds those parts of all rays of a beam.
Stretch within(const scene::Bounds& bounds, const Beam& beam);

/// Where at the latest those parts begin that have not ended by then.
double latest_begin(const scene::Bounds& bounds, const Beam& beam);

/// The outward unit normal of the bounds' wall near a point on it; 0 without bounds.
glm::dvec3 wall_normal(const scene::Bounds& bounds, glm::dvec3 point);

}  // namespace oracle
