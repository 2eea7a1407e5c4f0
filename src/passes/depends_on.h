// SPDX-License-Identifier: MIT
// What an expression needs.
#pragma once

#include <span>

#include "graph/graph.h"

namespace passes {

/// Whether the expression needs one of these variables.
bool depends_on(const graph::Graph& graph, graph::NodeId root,
                std::span<const graph::VariableId> variables);

}  // namespace passes
