// SPDX-License-Identifier: MIT
// Derivatives of expressions as expressions, which share what they can with the value.
#pragma once

#include <array>

#include "graph/graph.h"

namespace passes {

/// The partial derivative by a variable. At kinks the derivative of one side: of min and max that
/// of the first argument where both are equal, of abs 0; of floor, ceil and sign it is 0
/// everywhere. A length (hypot) has the derivative 0 where it is 0.
graph::NodeId differentiate(graph::Graph& graph, graph::NodeId root, graph::VariableId by);

/// The partial derivatives by x, y and z, passed through the passes.
std::array<graph::NodeId, 3> gradient(graph::Graph& graph, graph::NodeId root);

}  // namespace passes
