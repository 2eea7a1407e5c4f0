// SPDX-License-Identifier: MIT
// The shaders that people write by hand for a scene (tests/bench/plain/), to compare with.
#pragma once

#include <string>
#include <vector>

#include "bench/subject.h"
#include "shader/program_source.h"

namespace bench {

/// Names of those that are meant for a scene, of report.h: `plain` for a quaternion Julia set, a
/// Mandelbulb or a Menger sponge as shipped; for a scene of formulas and their set
/// operations `plain sphere`, where its slope is bounded over the region, and `plain first-order`;
/// none for all others.
std::vector<std::string> plain_names(const Subject& subject);

/// One of them with this scene's numbers: camera, bounds, lights, materials and the accuracy of a
/// hit are those of the frame; normals are by six evaluations, each light is asked for by one ray.
/// `outputs` are as for tracers; evaluations are always counted where normals are written.
shader::ProgramSource plain_source(const Subject& subject, const std::string& name,
                                   const shader::Outputs& outputs);

}  // namespace bench
