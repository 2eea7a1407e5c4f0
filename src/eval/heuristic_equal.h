// SPDX-License-Identifier: MIT
// Whether two expressions mean the same, by trying.
#pragma once

#include "graph/graph.h"

namespace eval {

/// True if both expressions have the same value up to rounding at some points, always the same
/// random ones (of all variables and parameters), at most half of which lie outside of their
/// domain. Heuristic: expressions that differ elsewhere only are taken for equal.
bool heuristic_equal(const graph::Graph& graph, graph::NodeId a, graph::NodeId b);

}  // namespace eval
