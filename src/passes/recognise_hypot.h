// SPDX-License-Identifier: MIT
// Lengths, typed out as roots of sums of squares.
#pragma once

#include "graph/graph.h"

namespace passes {

/// Rule: sqrt(a^2 + b^2) and sqrt(a^2 + b^2 + c^2) become hypot, sqrt(a^2) becomes abs(a). Up to
/// rounding. The analyses know that the gradient of a length is bounded, which they could not see
/// from a square root.
graph::NodeId recognise_hypot(graph::Graph& graph, graph::NodeId id);

}  // namespace passes
