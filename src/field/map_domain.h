// SPDX-License-Identifier: MIT
// A field seen through a map of space: its value at p is that of the original at m(p).
#pragma once

#include "field/field.h"

namespace field {

/// Through a similarity: `point` are expressions of the point, and distances are multiplied by
/// `stretch` (independent of the point), the factor that makes a distance at the new point a
/// distance again, 1 for isometries, a for `x / a`.
FieldId map_domain(Field& field, FieldId id, const Point& point, graph::NodeId stretch);

/// The same where `stretch` times the Lipschitz constant of the map is at most 1: distances become
/// bounds of distances. Not with Cells below.
FieldId bound_domain(Field& field, FieldId id, const Point& point, graph::NodeId stretch);

/// Through any map. Distances keep their values and remember what they were distorted by. Cells are
/// composed with the map: steps near their walls are then heuristic.
FieldId distort_domain(Field& field, FieldId id, const Point& point);

/// Turned about the z axis, counter-clockwise where that points at the eye, by an angle in radians
/// that depends on the point: a twist, or a bend.
FieldId turn_domain(Field& field, FieldId id, graph::NodeId angle);

/// True if there are Cells at or below the node.
bool has_cells(const Field& field, FieldId id);

}  // namespace field
