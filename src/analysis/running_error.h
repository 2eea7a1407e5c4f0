// SPDX-License-Identifier: MIT
// A bound of a formula's rounding error at a point, as an expression of the point.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "graph/graph.h"

namespace analysis {

/// How far the value of each root computed in single precision at a rounded point may be from the
/// exact one at the exact point: running error analysis (Higham, "Accuracy and Stability of
/// Numerical Algorithms", 2nd ed., 3.3), by what operator_accuracy.h promises. Made of the nodes of
/// `root`, and about twice as many more. `position` is by how much each variable is off; operators
/// err by `part` of what is promised (less than 1 for a machine that is more exact). To the first
/// order, but for products, which are counted in full: up to a part in some thousands. Nothing if
/// there are operators on the point that are steep, undefined or jump somewhere, but for absolute
/// values, minima and maxima.
std::vector<std::optional<graph::NodeId>> running_errors(graph::Graph& graph,
                                                         std::span<const graph::NodeId> roots,
                                                         graph::NodeId position, double part = 1);

}  // namespace analysis
