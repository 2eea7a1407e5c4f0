// SPDX-License-Identifier: MIT
// Sums, slow terms together.
#pragma once

#include <span>
#include <vector>

#include "graph/graph.h"

namespace passes {

/// Regroups sums in which several terms change at the same rate, but slower than the whole
/// (passes/rate.h): those are added first, so that x + a - 1 takes one addition at each point, and
/// what does not depend on the state of an iteration is added before its loop. Never more
/// operations. Up to rounding of the sum of the terms' sizes. Other sums stay as they are.
std::vector<graph::NodeId> gather_terms(graph::Graph& graph, std::span<const graph::NodeId> roots);

}  // namespace passes
