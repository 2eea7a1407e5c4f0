// SPDX-License-Identifier: MIT
// Division by what is the same for all points.
#pragma once

#include <span>
#include <vector>

#include "graph/graph.h"

namespace passes {

/// x / c becomes x * (1 / c) where c does not depend on the point and x does: the reciprocal is
/// computed once. Exact for constants that are powers of two, else up to rounding: 1 / c rounds
/// once more. Constants whose reciprocal is no normal number stay divisors (0 among them).
std::vector<graph::NodeId> divide_by_constants(graph::Graph& graph,
                                               std::span<const graph::NodeId> roots);

}  // namespace passes
