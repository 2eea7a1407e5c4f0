// SPDX-License-Identifier: MIT
// The signed value of a whole field at a point in double precision: the reference for what the
// shaders compute.
#pragma once

#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "field/field.h"

namespace eval {

/// f < 0 inside, f > 0 outside. A formula gives its graph's value, an iteration its answer or
/// -infinity where it never escapes (nothing is known about the depth), set operations the minimum,
/// the maximum and the negative. A blend calculates with the values of its operands; infinite ones
/// are the unknown depth of field.h there. In cells counts what is in the cell of the point.
///
/// Outside the domain of a solid leaf is outside: its NaN becomes +infinity before anything is done
/// with it. The NaN of a sheet stays and goes through all operations. `parameters` is indexed by
/// ParameterId; missing ones are 0. Makes tapes each time: for tests and single points.
double value(const field::Field& field, field::FieldId id, glm::dvec3 point,
             std::span<const double> parameters);

/// The own colour of a leaf at a point, linear RGB of at least 0; nothing if it has its material's.
/// An iteration is run as for its value.
std::optional<glm::dvec3> colour(const field::Field& field, field::FieldId leaf, glm::dvec3 point,
                                 std::span<const double> parameters);

}  // namespace eval
