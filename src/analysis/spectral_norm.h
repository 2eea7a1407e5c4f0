// SPDX-License-Identifier: MIT
// The largest absolute eigenvalue of a symmetric matrix, bounded from above for sure.
#pragma once

#include "numeric/interval.h"

namespace analysis {

/// A symmetric 3x3 matrix of the second derivatives of a function of x, y and z.
template <class T>
struct Symmetric {
    T xx{}, yy{}, zz{}, xy{}, xz{}, yz{};
};

/// At least sup |u^T A u| over unit vectors u, at most 2 % more.
double spectral_norm_bound(const Symmetric<double>& a);

/// At least the Frobenius norm, and so the spectral norm, of every symmetric matrix with entries in
/// these intervals: faster than the bound below, and up to sqrt(3) times larger.
double frobenius_norm_bound(const Symmetric<numeric::Interval>& a);

/// At least the spectral norm of every symmetric matrix with entries in these intervals; empty
/// entries count as 0.
double spectral_norm_bound(const Symmetric<numeric::Interval>& a);

}  // namespace analysis
