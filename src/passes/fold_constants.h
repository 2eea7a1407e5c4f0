// SPDX-License-Identifier: MIT
// Operators on constants become constants.
#pragma once

#include "graph/graph.h"

namespace passes {

/// Rule: an operator on constants becomes its value in double precision, if that is finite. A
/// division by zero and the like stay, so that what is undefined is so at run time as well.
graph::NodeId fold_constants(graph::Graph& graph, graph::NodeId id);

}  // namespace passes
