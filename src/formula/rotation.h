// SPDX-License-Identifier: MIT
// Rotation about an axis through the origin. Internal to the library.
#pragma once

#include <array>

#include "graph/graph.h"

namespace formula {

/// An axis of any length but 0.
using Direction = std::array<graph::NodeId, 3>;

/// The axis with the length 1.
Direction unit(graph::Graph& graph, const Direction& axis);

enum class Sense { forward, inverse };

/// The point turned about an axis by an angle in degrees, counter-clockwise where the axis points
/// at the eye; or by the same angle back. Exact for known multiples of 90 degrees.
std::array<graph::NodeId, 3> turned(graph::Graph& graph, const std::array<graph::NodeId, 3>& point,
                                    const Direction& axis, graph::NodeId degrees, Sense sense);

}  // namespace formula
