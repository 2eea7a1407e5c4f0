// SPDX-License-Identifier: MIT
// What a tracer needs to know about one formula over the visible region, for some parameter values.
#pragma once

#include <span>

#include "analysis/derivative_bounds.h"

namespace analysis {

struct LeafBounds {
    double lipschitz = numeric::infinity;          ///< rigorous: gradient_bound
    double second_derivative = numeric::infinity;  ///< rigorous: second_derivative_bound
    /// f may be undefined or jump somewhere in the region: then the bounds hold on each side, but
    /// no step across is certified. False is a proof.
    bool partial = true;
    /// Heuristic: certified steps by these bounds would be too many (heuristic_steps).
    bool stiff = true;
};

/// Takes a few milliseconds. `parameters` is indexed by ParameterId.
LeafBounds leaf_bounds(const eval::Tape& f, const Region& region,
                       std::span<const double> parameters, const Effort& effort = {});

}  // namespace analysis
