// SPDX-License-Identifier: MIT
// What an expression may be on the GPU: a running error analysis by intervals.
#pragma once

#include "contract/operator_table.h"
#include "graph/graph.h"
#include "numeric/interval.h"

namespace contract {

/// An interval that holds the value that GLSL finds at this point, if every operator keeps what the
/// operator table promises: each result is as uncertain as its arguments make it, and that much
/// more. `partial` means that it may also be NaN or infinite, empty that it is NaN for sure. The
/// point is variable 0 of the graph and the following ones. Wider than necessary where a number is
/// used more than once.
numeric::Interval gpu_enclosure(const graph::Graph& graph, graph::NodeId root,
                                const Arguments& point);

}  // namespace contract
