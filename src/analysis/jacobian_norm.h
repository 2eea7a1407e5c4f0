// SPDX-License-Identifier: MIT
// The Lipschitz constant of a map of space: the supremum of the spectral norm of its Jacobian
// (K 17), bounded by interval arithmetic.
#pragma once

#include <array>
#include <span>

#include "analysis/region.h"
#include "analysis/supremum.h"
#include "eval/tape.h"

namespace analysis {

/// A matrix by rows.
template <class T>
using Matrix = std::array<std::array<T, 3>, 3>;

/// At least the largest factor by which the matrix stretches a vector, at most 2 % more.
double stretch_bound(const Matrix<double>& a);
/// At least that of every matrix with entries in these intervals; empty entries count as 0.
double stretch_bound(const Matrix<numeric::Interval>& a);

/// At least the Lipschitz constant of a map over the region. +infinity if no bound was found, also
/// where the map may be undefined or jump. The roots of the map are its three components. A fourth
/// is an angle: the map goes to the components and then turns about the z axis by minus the angle.
/// Its Jacobian is a turn, which stretches nothing, of J + (y, -x, 0) (grad angle)^T with J, x and
/// y of the components, and that is bounded more sharply. `parameters` is indexed by ParameterId.
double jacobian_norm_bound(const eval::Tape& map, const Region& region,
                           std::span<const double> parameters, const Effort& effort = {});

}  // namespace analysis
