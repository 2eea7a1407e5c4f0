// SPDX-License-Identifier: MIT
// Whether one bound of the second derivative does for all of space.
#pragma once

#include "graph/graph.h"

namespace analysis {

/// True if, by structure, the second derivatives of the expression are about as large everywhere
/// (so that the square root of what is gained is little): a polynomial of degree 4 at most, or made
/// of sums and products of sines and cosines of linear expressions. False says nothing.
bool has_uniform_curvature(const graph::Graph& graph, graph::NodeId root);

}  // namespace analysis
