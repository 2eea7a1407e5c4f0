// SPDX-License-Identifier: MIT
// Whose surface a hit is, and which way it faces.
#pragma once

#include "oracle/first_hit.h"
#include "oracle/heuristic_distance.h"

namespace oracle {

struct Surface {
    int object = -1;
    glm::dvec3 normal{0};  ///< unit, facing the eye
};

/// Not for several threads.
class SurfaceFinder {
public:
    SurfaceFinder(const Shape& shape, const scene::Bounds& bounds);

    /// The normal is the gradient in double precision, of an iteration by differences over a
    /// pixel's `footprint`, of a cap that of the wall of the bounds, and -direction where there is
    /// none.
    Surface operator()(const Ray& ray, const Found& found, double footprint);

private:
    using Gradient = numeric::Dual<double>;

    glm::dvec3 gradient(const Found& found, std::size_t leaf, glm::dvec3 point, double footprint);
    glm::dvec3 differences(std::size_t solid, glm::dvec3 point, double size);

    const Shape& shape_;
    scene::Bounds bounds_;
    HeuristicDistance distance_;
    Values<Gradient> gradients_;
};

}  // namespace oracle
