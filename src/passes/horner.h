// SPDX-License-Identifier: MIT
// Polynomials with their common factors out.
#pragma once

#include <span>
#include <vector>

#include "graph/graph.h"

namespace passes {

/// Sums of products give up common factors, the one first that most of the terms have (greedy; for
/// one variable that is Horner's form): x^3 y + x^2 + 2 x becomes x (x (x y + 1) + 2). Of sums with
/// more than 64 terms each 64 for themselves. Only where that takes fewer operations at each point,
/// with all that is shared counted. Up to rounding of parts of the sum of the terms' sizes. For
/// evaluation alone: the derivatives are taken and the bounds found before, from the form in which
/// powers stand.
std::vector<graph::NodeId> horner(graph::Graph& graph, std::span<const graph::NodeId> roots);

}  // namespace passes
