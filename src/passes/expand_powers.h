// SPDX-License-Identifier: MIT
// Whole powers by multiplication.
#pragma once

#include "graph/graph.h"

namespace passes {

/// Rule: a constant whole exponent up to 64 becomes multiplications (by squaring), a negative one
/// the reciprocal of such, 1/2 and -1/2 square roots; the power of 0 of anything but a leaf stays,
/// because the base may be undefined. Up to rounding: each multiplication rounds once.
graph::NodeId expand_powers(graph::Graph& graph, graph::NodeId id);

}  // namespace passes
