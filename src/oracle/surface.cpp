// SPDX-License-Identifier: MIT
#include "oracle/surface.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace oracle {
namespace {

/// Unit, or 0 where there is none.
glm::dvec3 direction_of(const glm::dvec3& v) {
    const double most = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(most > 0) || !std::isfinite(v.x + v.y + v.z)) return glm::dvec3(0);
    return glm::normalize(v / most);
}

}  // namespace

SurfaceFinder::SurfaceFinder(const Shape& shape, const scene::Bounds& bounds)
    : shape_(shape), bounds_(bounds), distance_(shape), gradients_(shape) {}

/// By four differences on a tetrahedron.
glm::dvec3 SurfaceFinder::differences(std::size_t solid, glm::dvec3 point, double size) {
    glm::dvec3 sum(0);
    for (const glm::dvec3 corner : {glm::dvec3(1, -1, -1), glm::dvec3(-1, -1, 1),
                                    glm::dvec3(-1, 1, -1), glm::dvec3(1, 1, 1)}) {
        const double value = distance_(solid, point + size * corner);
        // Inside of an escape-time set nothing is known of the distance.
        if (std::isfinite(value)) sum += corner * value;
    }
    return sum;
}

glm::dvec3 SurfaceFinder::gradient(const Found& found, std::size_t leaf, glm::dvec3 point,
                                   double footprint) {
    if (found.of == Found::Of::solid && shape_.solids[shape_.parts[found.number].solid].has_loops &&
        shape_.solids[leaf].has_loops) {
        return differences(leaf, point, footprint);
    }
    gradients_.move_to({Gradient::variable(point.x, 0), Gradient::variable(point.y, 1),
                        Gradient::variable(point.z, 2)});
    const Gradient value = found.of == Found::Of::sheet
                               ? gradients_.expression(shape_.sheets[found.number].source)
                               : gradients_.solid(leaf);
    return {value.gradient[0], value.gradient[1], value.gradient[2]};
}

Surface SurfaceFinder::operator()(const Ray& ray, const Found& found, double footprint) {
    // On a wall of cells the middle may be on either side; what is seen is behind it.
    const bool behind = found.verdict == Verdict::hit && found.of == Found::Of::solid;
    const double t = behind ? found.far : found.middle();
    const glm::dvec3 point = ray.at(t);
    Surface surface;
    std::size_t decides = 0;
    if (found.of == Found::Of::sheet) {
        surface.object = shape_.sheets[found.number].object;
    } else {
        decides = shape_.parts[found.number].solid;
        surface.object = shape_.solids[distance_.leaf(decides, point)].object;
        while (shape_.solids[decides].what != Solid::What::blend &&
               !shape_.solids[decides].operands.empty()) {
            decides = distance_.operand(decides, point);
        }
    }
    if (found.at_start) {
        if (t > 0) surface.normal = wall_normal(bounds_, point);
    } else {
        // Where the gradient vanishes at the surface, as at a double root, a little before it.
        for (const double offset : {0.0, -1e-7, -1e-5, 1e-7, 1e-5}) {
            const glm::dvec3 at = ray.at(t * (1 + offset));
            surface.normal = direction_of(gradient(found, decides, at, footprint));
            if (surface.normal != glm::dvec3(0)) break;
        }
    }
    if (surface.normal == glm::dvec3(0)) surface.normal = -ray.direction;
    if (glm::dot(surface.normal, ray.direction) > 0) surface.normal = -surface.normal;
    return surface;
}

}  // namespace oracle
