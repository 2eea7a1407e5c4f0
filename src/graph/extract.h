// SPDX-License-Identifier: MIT
// A part of a graph as a graph of its own.
#pragma once

#include <span>
#include <vector>

#include "graph/graph.h"

namespace graph {

/// Some expressions with nothing else around them.
struct Extract {
    Graph graph;
    std::vector<NodeId> roots;  ///< in the order in which they were asked for
};

/// What the roots need, in a graph that is no larger. All variables and parameters keep their ids;
/// nodes get new ones in the same order. For work whose time should grow with the part.
Extract extract(const Graph& graph, std::span<const NodeId> roots);

}  // namespace graph
