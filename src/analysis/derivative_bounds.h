// SPDX-License-Identifier: MIT
// Rigorous bounds of a formula's first and second derivatives over a region, by jets of intervals:
// value, gradient and Hessian are enclosed at once. A formula is a tape with one root.
#pragma once

#include <span>

#include "analysis/region.h"
#include "analysis/supremum.h"
#include "eval/tape.h"

namespace analysis {

/// False if f is proven to be defined and continuous in the whole region. True may also mean that
/// no proof was found with this effort. `parameters` is indexed by ParameterId, here and below.
bool may_break(const eval::Tape& f, const Region& region, std::span<const double> parameters,
               const Effort& effort);

/// At least sup |grad f| over the points of the region where f is defined: a Lipschitz constant on
/// every straight way on which f does not break. +infinity if no bound was found.
double gradient_bound(const eval::Tape& f, const Region& region, std::span<const double> parameters,
                      const Effort& effort);

/// At least sup |d^2/dt^2 f(o + t d)| over the region and unit directions d: the spectral norm of
/// the Hessian. +infinity if no bound was found, also where the gradient may jump.
double second_derivative_bound(const eval::Tape& f, const Region& region,
                               std::span<const double> parameters, const Effort& effort);

}  // namespace analysis
