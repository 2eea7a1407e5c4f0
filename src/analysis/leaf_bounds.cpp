// SPDX-License-Identifier: MIT
#include "analysis/leaf_bounds.h"

#include "analysis/heuristic_stiffness.h"

namespace analysis {

LeafBounds leaf_bounds(const DerivativeTapes& tapes, const Region& region,
                       std::span<const double> parameters, const Effort& effort) {
    LeafBounds bounds;
    bounds.partial = may_break(tapes, region, parameters, effort);
    bounds.lipschitz = gradient_bound(tapes, region, parameters, effort);
    bounds.second_derivative = second_derivative_bound(tapes, region, parameters, effort);
    bounds.stiff = heuristic_steps(tapes, region, parameters, bounds.lipschitz,
                                   bounds.second_derivative) > stiff_steps;
    return bounds;
}

}  // namespace analysis
