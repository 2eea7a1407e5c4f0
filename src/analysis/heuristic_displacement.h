// SPDX-License-Identifier: MIT
// How far rounding moves a surface.
#pragma once

#include <optional>
#include <span>

#include "analysis/region.h"
#include "eval/tape.h"

namespace analysis {

/// Heuristic. By how much single precision moves the surface f = 0, in the units of space: the
/// bound of the rounding error (rounding_error.h), where the point is off by `position` in every
/// coordinate, over the gradient, at the third quartile of up to `samples` points of the region
/// that lie about on the surface. Nothing if none was found. +infinity where no error is bounded.
/// `parameters` is indexed by ParameterId.
std::optional<double> heuristic_displacement(const eval::Tape& f, const Region& region,
                                             std::span<const double> parameters, double position,
                                             unsigned samples = 48);

}  // namespace analysis
