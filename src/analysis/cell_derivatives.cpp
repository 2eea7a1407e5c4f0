// SPDX-License-Identifier: MIT
#include "analysis/cell_derivatives.h"

#include <algorithm>
#include <span>

namespace analysis {
namespace {

using numeric::Interval;

/// True if an enclosure says nothing about the derivative at some point where f has a value: the
/// formula of the derivative may be undefined there.
bool has_gap(std::span<const Interval> derivatives, const Interval& f) {
    return std::ranges::any_of(
        derivatives, [&](const Interval& d) { return d.is_empty() || (d.partial && !f.partial); });
}

}  // namespace

template <numeric::AnyJet J>
double gradient_bound_on(const J& f) {
    if (f.value.is_empty()) return 0;
    if (has_gap(f.gradient, f.value)) return numeric::infinity;
    const auto [dx, dy, dz] = f.gradient;
    return sqrt(square(dx) + square(dy) + square(dz)).hi;
}
template double gradient_bound_on(const numeric::Dual<Interval>&);
template double gradient_bound_on(const numeric::SecondOrder<Interval>&);

double second_derivative_bound_on(const numeric::SecondOrder<Interval>& f, double known) {
    if (f.value.is_empty()) return 0;
    const bool kinks = std::ranges::any_of(f.gradient, &Interval::jumps);
    if (kinks || has_gap(f.gradient, f.value) || has_gap(f.hessian, f.value)) {
        return numeric::infinity;
    }
    const Symmetric<Interval> hessian = hessian_matrix(f.hessian);
    const double rough = frobenius_norm_bound(hessian);
    return rough <= known ? rough : spectral_norm_bound(hessian);
}

}  // namespace analysis
