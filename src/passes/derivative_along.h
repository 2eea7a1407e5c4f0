// SPDX-License-Identifier: MIT
// How an expression changes along a ray.
#pragma once

#include <array>

#include "graph/graph.h"

namespace passes {

/// d/ds of f(p + s d) at s = 0, for the direction d that these three nodes hold; passed through the
/// passes. They may be parameters, or variables for a ray of each point's own. Not normalised: the
/// derivative is by the length of d. Applied twice it is the second derivative along the ray. Kinks
/// as in passes/differentiate.h.
graph::NodeId derivative_along(graph::Graph& graph, graph::NodeId f,
                               const std::array<graph::NodeId, 3>& direction);

}  // namespace passes
