// SPDX-License-Identifier: MIT
// The pinhole camera and the region that is looked at.
#pragma once

#include <glm/vec3.hpp>

namespace scene {

/// The fields of view that a camera can have, in degrees.
inline constexpr double least_fov = 0.1;
inline constexpr double greatest_fov = 175;

/// World coordinates, right-handed, +y up by default. `fov` is the full vertical angle in degrees.
struct Camera {
    glm::dvec3 eye{0};
    glm::dvec3 target{0};
    glm::dvec3 up{0, 1, 0};
    double fov = 45;

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// The region that is looked at: sheets end at its wall, solids are capped there.
struct Bounds {
    enum class Shape { sphere, box, none };
    Shape shape = Shape::sphere;
    glm::dvec3 centre{0};
    glm::dvec3 half{2};  ///< half extents of a box; the radius of a sphere in every component

    friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// How far rays go where there are no bounds, in world units from the eye.
inline constexpr double far_distance = 1000;

/// The region as analyses and framing see it: without bounds, the sphere of radius 2.
Bounds framed_region(const Bounds& bounds);

/// The camera's axes: w forward, u right, v up; orthonormal. Where `up` is parallel to the view, +z
/// stands in, else +x. An eye on the target looks along -z.
struct Axes {
    glm::dvec3 u, v, w;
};
Axes axes(const Camera& camera);

/// Looks at the centre of the bounds from the direction (1, 0.8, 1.6), so that their bounding
/// sphere fills the picture of the given aspect (width / height): it keeps 4 % of the way from the
/// centre to the nearer pair of edges free.
Camera frame_all(const Bounds& bounds, double aspect, double fov = 45);

/// The same view direction, up and field of view, moved so that the bounds fill the picture.
Camera frame_from(const Camera& camera, const Bounds& bounds, double aspect);

/// Turns the eye around the target by angles in radians: about `up` (to the right for positive
/// angles), then towards it (up for positive angles). Stops short of the poles. Angles that are not
/// finite turn nothing.
Camera orbit(const Camera& camera, double yaw, double pitch);
/// Moves eye and target together, in fractions of the picture's height at the target. What is not
/// finite moves nothing.
Camera pan(const Camera& camera, double right, double up);
/// Multiplies the distance from the target and keeps it between 1e-11 (times the target's way from
/// the origin where that is more than 1) and 1e6; any other factor than a finite one above 0
/// changes nothing.
Camera dolly(const Camera& camera, double factor);

}  // namespace scene
