// SPDX-License-Identifier: MIT
// Where an expression may be undefined, and where it may jump or have a kink.
#pragma once

#include <span>
#include <vector>

#include "field/field.h"
#include "graph/graph.h"

namespace shader {

/// True if one of the expressions holds an operator on the point that is not defined everywhere
/// (division, root, logarithm, power, inverse sine or cosine, tangent): by structure, so a false
/// alarm is possible and a miss is not, but for overflow.
bool may_be_undefined(const graph::Graph& graph, std::span<const graph::NodeId> roots);

/// For each node of the field's graph whether it may be NaN at a finite point: by structure, so a
/// false alarm is possible and a miss is not, but for overflow.
std::vector<bool> may_be_nan(const field::Field& field);

/// True if one of the expressions holds an operator on the point that may jump or have a kink
/// without being undefined (whole parts, sign, comparison, the angle of two numbers, a ratio at the
/// origin; absolute value, minimum, maximum, length, cubic root): by structure, as above.
bool may_break(const graph::Graph& graph, std::span<const graph::NodeId> roots);

}  // namespace shader
