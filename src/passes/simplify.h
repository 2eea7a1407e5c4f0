// SPDX-License-Identifier: MIT
// Identities of arithmetic that keep the value.
#pragma once

#include "graph/graph.h"

namespace passes {

/// Rule: drops neutral operands (x + 0, x * 1, x / 1, x - 0), double negations, and joins a sign
/// with a sum (x + -y, x - -y, x * -1, abs(-x)). Exact, but for the sign of a zero (x + 0 where x
/// is -0). A product with 0 and a choice between equals stay: they are undefined where the other
/// factor or the comparison is.
graph::NodeId simplify(graph::Graph& graph, graph::NodeId id);

}  // namespace passes
