// SPDX-License-Identifier: MIT
// Scenes whose right picture is known in closed form: spheres, planes, nothing.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "oracle/reference.h"
#include "scene/document.h"

namespace torture {

struct ExactSphere {
    glm::dvec3 centre{0};
    double radius = 1;
};
struct ExactPlane {  ///< normal . p = offset
    glm::dvec3 normal{0, 0, 1};
    double offset = 0;
};
struct ExactBounds {};  ///< all of the bounds, as a solid
struct ExactAtEye {};   ///< the eye is in a solid or on a sheet
struct ExactNothing {};
using ExactShape = std::variant<ExactSphere, ExactPlane, ExactBounds, ExactAtEye, ExactNothing>;

/// The shape that a scene shows, cut off at its bounds; none if it is not known in closed form.
std::optional<ExactShape> exact_shape(const std::string& scene_name);

/// The names that have one.
std::vector<std::string> exact_scene_names();

/// The reference of a shape, to the last places of double precision. Pixels are fragile as the
/// oracle defines it, by eight rays around the pixel's own.
oracle::Reference exact_reference(const ExactShape& shape, const scene::Document& document,
                                  int width, int height);

/// Replaces what the oracle could not decide by another answer.
void decide(oracle::Reference& reference, const oracle::Reference& answer);

}  // namespace torture
