// SPDX-License-Identifier: MIT
// In which numbers a scene must be calculated, so that its picture is sharp.
#pragma once

#include <string>

#include <glm/vec3.hpp>

#include "compile/compile.h"
#include "scene/document.h"
#include "shader/precision.h"

namespace compile {

struct PrecisionChoice {
    shader::Precision precision = shader::Precision::single;
    std::string reason;  ///< a clause for people
};

/// The settings' precision; where that is `auto`, the cheapest one that moves no surface by more
/// than an eighth of a pixel where the camera looks, in a picture of 1080 rows (so that the program
/// does not depend on the window's size): heuristic_displacement of formulas about the target. Of
/// iterations, and of what is in cells, only the rounding of the point is counted, times what was
/// found to be enough. Heuristic. A millisecond or two.
PrecisionChoice choose_precision(const Formula& formula, const scene::Document& document);

/// True unless the camera of one looks so much closer or elsewhere than that of the other that the
/// precision should be chosen, or coordinates recentred, anew.
bool look_alike(const scene::Document& a, const scene::Document& b);

/// The origin of the program's coordinates where they are recentred: what the camera looks at.
glm::dvec3 recentred_origin(const scene::Document& document);

}  // namespace compile
