// SPDX-License-Identifier: MIT
// Products, slow factors first.
#pragma once

#include <span>
#include <vector>

#include "graph/graph.h"

namespace passes {

/// Regroups products: constants become one, factors that change at the same rate (passes/rate.h)
/// are multiplied with each other first, from slow to fast, signs come out, equal factors become
/// powers, and the others get one order, so that products share their beginnings. 2 * a * x * b
/// takes one multiplication at each point. Never more operations. Up to rounding, which happens
/// elsewhere; and where a product of some factors overflows or vanishes, others may.
std::vector<graph::NodeId> gather_factors(graph::Graph& graph,
                                          std::span<const graph::NodeId> roots);

}  // namespace passes
