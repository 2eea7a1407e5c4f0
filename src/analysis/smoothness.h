// SPDX-License-Identifier: MIT
// How smooth an expression is as a function of the point, by its structure alone.
#pragma once

#include "graph/graph.h"

namespace analysis {

/// In increasing order of trouble.
enum class Smoothness {
    smooth,         ///< all derivatives exist inside the domain
    piecewise,      ///< continuous inside the domain, with kinks
    discontinuous,  ///< may jump
};

/// The worst operator that depends on a variable: abs, min and max have kinks; floor, ceil, sign,
/// atan2 (at its cut) and select_less jump, the latter also in derivatives of min and max, where it
/// stands for the derivative's jump at the kink; hypot, hypot3 and cbrt have a kink at 0, ratio
/// jumps there. All others, sqrt and powers too, are smooth inside their domains; poles and domain
/// edges are for interval arithmetic to find (may_break), which also proves where jumps are not
/// met.
Smoothness smoothness(const graph::Graph& graph, graph::NodeId root);

}  // namespace analysis
