// SPDX-License-Identifier: MIT
// A guess whether certified steps would be too small to be of use.
#pragma once

#include <span>

#include "analysis/derivative_bounds.h"

namespace analysis {

/// Steps that a ray may need before a formula is called stiff.
inline constexpr double stiff_steps = 200;

/// Heuristic. The number of certified steps on a way through the whole region, guessed from the
/// median step over points spread in the region: |f| / L by the bound L of the gradient or
/// sqrt(2 |f| / M) by the bound M of the second derivative, whichever is larger. +infinity if both
/// bounds are infinite.
double heuristic_steps(const eval::Tape& f, const Region& region,
                       std::span<const double> parameters, double lipschitz,
                       double second_derivative);

}  // namespace analysis
