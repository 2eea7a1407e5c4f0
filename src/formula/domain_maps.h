// SPDX-License-Identifier: MIT
// Moving, turning, scaling and bending a field, by the inverse map of its points. Internal to the
// library.
#pragma once

#include <array>

#include "field/field.h"

namespace formula {

using Vector = std::array<graph::NodeId, 3>;

field::FieldId translate(field::Field& field, field::FieldId id, const Vector& offset);

/// About an axis through the origin by an angle in degrees, counter-clockwise where the axis points
/// at the eye. The axis may have any length but 0.
field::FieldId rotate(field::Field& field, field::FieldId id, const Vector& axis,
                      graph::NodeId degrees);

/// By the same factor > 0 in all directions.
field::FieldId scale(field::Field& field, field::FieldId id, graph::NodeId factor);

/// By a factor > 0 for each coordinate. Distances become bounds: multiplied by the least factor.
field::FieldId scale(field::Field& field, field::FieldId id, const Vector& factors);

/// Turned about the z axis by half of the curvature times x: what lies along the x axis bends
/// towards y, at the origin with this curvature. (The chord of an arc is turned by half of the
/// arc's angle; here x stands for the arc's length.)
field::FieldId bend(field::Field& field, field::FieldId id, graph::NodeId curvature);

}  // namespace formula
