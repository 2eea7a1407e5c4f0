// SPDX-License-Identifier: MIT
// Where an expression is 0, said by expressions that cross 0 there.
#pragma once

#include <vector>

#include "graph/graph.h"

namespace oracle {

/// The places where `zero` is 0 (or `below`: at most 0) and every guard is defined and not 0.
struct ZeroSet {
    graph::NodeId zero{};
    std::vector<graph::NodeId> guards;
    bool below = false;  ///< only without guards
};

/// The zeros of the expression as a union, exact for real numbers: roots, absolute values and
/// powers are taken off, factors looked at by themselves, fractions brought to a common
/// denominator. So what touches 0 because it is written as a square crosses it, and poles are no
/// sheets. What is never 0 gives nothing. New nodes go into the graph.
std::vector<ZeroSet> zero_sets(graph::Graph& graph, graph::NodeId id);

}  // namespace oracle
