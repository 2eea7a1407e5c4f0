// SPDX-License-Identifier: MIT
// How much there is to compute.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "graph/graph.h"

namespace passes {

/// Operations that some expressions need, each node once. Leaves are none.
struct OperationCount {
    /// By operator (graph::Op), of those that depend on the point or on an iteration's state.
    std::array<std::size_t, graph::operator_count> by_operator{};
    std::size_t at_points = 0;  ///< the sum of by_operator
    std::size_t hoisted = 0;    ///< those that depend on parameters alone: once a frame, on the CPU
    /// at_points, but with each whole power up to 64 counted as its multiplications, and any other
    /// power as more than those.
    std::size_t multiplied_out = 0;
};

OperationCount count_operations(const graph::Graph& graph, std::span<const graph::NodeId> roots);

}  // namespace passes
