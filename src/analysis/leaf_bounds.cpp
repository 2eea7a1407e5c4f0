// SPDX-License-Identifier: MIT
#include "analysis/leaf_bounds.h"

#include "analysis/heuristic_stiffness.h"

namespace analysis {

LeafBounds leaf_bounds(const eval::Tape& f, const Region& region,
                       std::span<const double> parameters, const Effort& effort) {
    LeafBounds bounds;
    bounds.partial = may_break(f, region, parameters, effort);
    bounds.lipschitz = gradient_bound(f, region, parameters, effort);
    bounds.second_derivative = second_derivative_bound(f, region, parameters, effort);
    bounds.stiff = heuristic_steps(f, region, parameters, bounds.lipschitz,
                                   bounds.second_derivative) > stiff_steps;
    return bounds;
}

}  // namespace analysis
