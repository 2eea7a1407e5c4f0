// SPDX-License-Identifier: MIT
// One order for the operands of what is commutative.
#pragma once

#include "graph/graph.h"

namespace passes {

/// True if a stands before b: constants by size, then parameters and variables by number, then
/// operators in the order in which the graph got them. A total order, the same for the same text.
bool stands_before(const graph::Graph& graph, graph::NodeId a, graph::NodeId b);

/// Rule: the operands of a sum, a product or a length of two come in that order, so that a * b and
/// b * a are one node. Exact. Minimum and maximum keep theirs, which says whose derivative counts
/// where both are equal.
graph::NodeId order_operands(graph::Graph& graph, graph::NodeId id);

}  // namespace passes
