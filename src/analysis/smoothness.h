// SPDX-License-Identifier: MIT
// How smooth an expression is over a region.
#pragma once

#include <span>

#include "analysis/region.h"
#include "analysis/supremum.h"
#include "graph/graph.h"

namespace analysis {

/// In increasing order of trouble; each is a proof for the points of the region where the
/// expression is defined. A worse answer than the true one may mean that no proof was found.
enum class Smoothness {
    smooth,         ///< all derivatives exist
    piecewise,      ///< continuous, may have kinks
    discontinuous,  ///< may jump
};

struct Regularity {
    Smoothness smoothness = Smoothness::discontinuous;
    bool partial = true;  ///< may be undefined somewhere in the region; false is a proof

    friend bool operator==(const Regularity&, const Regularity&) = default;
};

/// By interval arithmetic on every operator that can have a kink, a jump or an edge: it does where
/// the arguments' enclosures reach it, and the region is halved where they do. `parameters` is
/// indexed by ParameterId. Variables other than x, y and z may have any value.
Regularity regularity(const graph::Graph& graph, graph::NodeId root, const Region& region,
                      std::span<const double> parameters, const Effort& effort);

}  // namespace analysis
