// SPDX-License-Identifier: MIT
// Sums and products as trees that may be regrouped.
#pragma once

#include <span>
#include <vector>

#include "graph/graph.h"

namespace passes {

/// Which nodes the roots need, and how often each is used.
struct Usage {
    std::vector<graph::NodeId> order;  ///< graph::reachable
    std::vector<std::uint32_t> count;  ///< by node; a root counts as a use
};
Usage usage(const graph::Graph& graph, std::span<const graph::NodeId> roots);

/// For each node whether it is a part of a larger tree of these operators: it is such an operator,
/// and its only user is one as well. What is used elsewhere too is no part, so that regrouping a
/// tree computes nothing twice.
std::vector<bool> inner_nodes(const graph::Graph& graph, const Usage& usage,
                              std::span<const graph::Op> operators);

}  // namespace passes
