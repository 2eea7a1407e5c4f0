// SPDX-License-Identifier: MIT
// Copies of a field in the cells of a partition of space. What is larger than its cell is cut off
// at the walls. Numbers do not depend on the point.
#pragma once

#include "field/field.h"

namespace field {

/// A copy in each box of a grid around the origin; a size of 0 does not repeat in its direction.
/// With `count` only that many copies in each direction (rounded, at least 1), centred as a whole.
FieldId repeat(Field& field, FieldId a, const Point& cell, const std::optional<Point>& count);

/// n copies (rounded, at least 1) about the z axis, each in its wedge; the first around the
/// positive x axis.
FieldId repeat_polar(Field& field, FieldId a, graph::NodeId n);

/// What is in front of the plane unit . p = d, and its mirror image behind it. Distances stay
/// distances; cells are only made where there are cells below.
FieldId mirror(Field& field, FieldId a, const Point& unit, graph::NodeId d);

}  // namespace field
