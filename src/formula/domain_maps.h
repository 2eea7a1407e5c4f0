// SPDX-License-Identifier: MIT
// Moving, turning and scaling a field, by the inverse map of its points. Internal to the library.
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

}  // namespace formula
