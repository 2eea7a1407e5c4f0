// SPDX-License-Identifier: MIT
// Graphs as text for people.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "graph/graph.h"

namespace graph {

/// The number in its shortest form that reads back the same, in the C locale.
std::string shortest(double value);

/// One line for each node that the roots need: `n3 = mul n1 n2`. Numbers count from 0 in the order
/// of evaluation, so that the text depends on the expression alone. `names` gets the printed name
/// of each root, in order.
std::string print(const Graph& graph, std::span<const NodeId> roots,
                  std::vector<std::string>* names = nullptr);

}  // namespace graph
