// SPDX-License-Identifier: MIT
// Rigorous bounds of a formula's first and second derivatives over a region, by interval
// arithmetic.
#pragma once

#include <span>

#include "analysis/region.h"
#include "analysis/supremum.h"
#include "eval/tape.h"

namespace analysis {

/// A formula with its derivatives, flattened. Made once for a formula; good for all parameter
/// values.
struct DerivativeTapes {
    eval::Tape value;     ///< f
    eval::Tape gradient;  ///< f, and its derivatives by x, y, z
    eval::Tape hessian;   ///< all of those, and the second derivatives xx, yy, zz, xy, xz, yz
};

/// The graph is copied, not changed.
DerivativeTapes derivative_tapes(const graph::Graph& graph, graph::NodeId f);

/// False if f is proven to be defined and continuous in the whole region. True may also mean that
/// no proof was found with this effort. `parameters` is indexed by ParameterId, here and below.
bool may_break(const DerivativeTapes& tapes, const Region& region,
               std::span<const double> parameters, const Effort& effort);

/// At least sup |grad f| over the points of the region where f is defined: a Lipschitz constant on
/// every straight way on which f does not break. +infinity if no bound was found.
double gradient_bound(const DerivativeTapes& tapes, const Region& region,
                      std::span<const double> parameters, const Effort& effort);

/// At least sup |d^2/dt^2 f(o + t d)| over the region and unit directions d: the spectral norm of
/// the Hessian. +infinity if no bound was found, also where the gradient may jump.
double second_derivative_bound(const DerivativeTapes& tapes, const Region& region,
                               std::span<const double> parameters, const Effort& effort);

}  // namespace analysis
