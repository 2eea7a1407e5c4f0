// SPDX-License-Identifier: MIT
// Bounds of derivatives over one cell, from enclosures of a formula's value, gradient and Hessian.
#pragma once

#include "analysis/spectral_norm.h"
#include "numeric/jet.h"

namespace analysis {

/// At least sup |grad f| over the points of the cell where f is defined; +infinity if the enclosure
/// says nothing. `f` encloses value and gradient over the cell.
template <numeric::AnyJet J>
double gradient_bound_on(const J& f);

/// At least the spectral norm of the Hessian over the cell; +infinity if the enclosure says
/// nothing, or the gradient may jump. Rough where it is below `known` even so.
double second_derivative_bound_on(const numeric::SecondOrder<numeric::Interval>& f, double known);

/// True if f may be undefined or jump somewhere in the cell.
inline bool may_break_on(const numeric::Interval& f) { return f.partial || f.jumps; }

template <class T>
Symmetric<T> hessian_matrix(const std::array<T, 6>& hessian) {
    const auto entry = [&](int i, int j) {
        return hessian[static_cast<std::size_t>(numeric::triangle_place(i, j, 3))];
    };
    return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
}

}  // namespace analysis
