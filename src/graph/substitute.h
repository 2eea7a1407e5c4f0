// SPDX-License-Identifier: MIT
// Replacing variables of an expression by expressions.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "graph/graph.h"

namespace graph {

/// Each root with every listed variable replaced, all at once; other leaves stay.
std::vector<NodeId> substitute(Graph& graph, std::span<const NodeId> roots,
                               std::span<const std::pair<VariableId, NodeId>> replacements);

}  // namespace graph
