// SPDX-License-Identifier: MIT
// Where in space an expression jumps.
#pragma once

#include <vector>

#include "graph/graph.h"

namespace passes {

/// Whether the expression may jump, and does so on planes only: each argument of a floor, ceil,
/// sign or comparison in it is affine in x, y and z where none of the others jumps. By structure;
/// no other operator on the point may jump.
bool jumps_at_planes(const graph::Graph& graph, graph::NodeId root);

/// Of such an expression: how far from the point, in units of what is rounded or compared, its next
/// values are where it jumps; not negative. Jumps are nowhere else than where one of them is 0, and
/// the derivatives of each say how fast it changes with the point. For others nothing.
std::vector<graph::NodeId> jump_walls(graph::Graph& graph, graph::NodeId root);

}  // namespace passes
