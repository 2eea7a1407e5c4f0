// SPDX-License-Identifier: MIT
#include "analysis/spectral_norm.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace analysis {
namespace {

using numeric::Interval;

/// Far more than the rounding errors of the few dozen operations on numbers of like size below.
constexpr double rounding_allowance = 1 + 1e-12;

double largest_entry(const Symmetric<double>& a) {
    return std::max({std::abs(a.xx), std::abs(a.yy), std::abs(a.zz), std::abs(a.xy), std::abs(a.xz),
                     std::abs(a.yz)});
}

double squared_frobenius_norm(const Symmetric<double>& a) {
    return a.xx * a.xx + a.yy * a.yy + a.zz * a.zz + 2 * (a.xy * a.xy + a.xz * a.xz + a.yz * a.yz);
}

Symmetric<double> divided(const Symmetric<double>& a, double by) {
    return {a.xx / by, a.yy / by, a.zz / by, a.xy / by, a.xz / by, a.yz / by};
}

Symmetric<double> squared(const Symmetric<double>& a) {
    return {.xx = a.xx * a.xx + a.xy * a.xy + a.xz * a.xz,
            .yy = a.xy * a.xy + a.yy * a.yy + a.yz * a.yz,
            .zz = a.xz * a.xz + a.yz * a.yz + a.zz * a.zz,
            .xy = a.xx * a.xy + a.xy * a.yy + a.xz * a.yz,
            .xz = a.xx * a.xz + a.xy * a.yz + a.xz * a.zz,
            .yz = a.xy * a.xz + a.yy * a.yz + a.yz * a.zz};
}

template <class Map>
Symmetric<double> map(const Symmetric<Interval>& a, Map entry) {
    return {entry(a.xx), entry(a.yy), entry(a.zz), entry(a.xy), entry(a.xz), entry(a.yz)};
}

}  // namespace

double spectral_norm_bound(const Symmetric<double>& a) {
    // |A| = |A^(2^k)|^(1 / 2^k), and the Frobenius norm is at least the spectral norm and at most
    // sqrt(3) times it: with k = 5 the bound is too large by 3^(1/64) at most. Each square is
    // scaled back to entries of at most 1.
    const double scale = largest_entry(a);
    if (scale == 0) return 0;
    if (!std::isfinite(scale)) return numeric::infinity;
    Symmetric<double> power = divided(a, scale);
    std::array<double, 5> scales{};
    for (double& largest : scales) {
        power = squared(power);
        largest = largest_entry(power);
        power = divided(power, largest);
    }
    double norm = std::sqrt(squared_frobenius_norm(power));
    for (std::size_t i = scales.size(); i-- > 0;) norm = std::sqrt(scales[i] * norm);
    return scale * norm * rounding_allowance;
}

double frobenius_norm_bound(const Symmetric<Interval>& a) {
    const Symmetric<double> magnitudes = map(a, [](const Interval& i) { return magnitude(i); });
    // Squares that vanish are made up for.
    return std::sqrt(squared_frobenius_norm(magnitudes)) * rounding_allowance + 1e-150;
}

double spectral_norm_bound(const Symmetric<Interval>& a) {
    const Symmetric<double> magnitudes = map(a, [](const Interval& i) { return magnitude(i); });
    if (!std::isfinite(largest_entry(magnitudes))) return numeric::infinity;
    const Symmetric<double> middle =
        map(a, [](const Interval& i) { return i.is_empty() ? 0 : 0.5 * i.lo + 0.5 * i.hi; });
    const Symmetric<double> radius = map(a, [](const Interval& i) {
        if (i.is_empty()) return 0.0;
        const double m = 0.5 * i.lo + 0.5 * i.hi;
        return std::max(numeric::add_up(i.hi, -m), numeric::add_up(m, -i.lo));
    });
    // The norm does not shrink when entries are replaced by larger absolute values; and the
    // triangle inequality for middle and radius keeps the signs of the middle.
    const double by_signs =
        (spectral_norm_bound(middle) + spectral_norm_bound(radius)) * rounding_allowance;
    return std::min(spectral_norm_bound(magnitudes), by_signs);
}

}  // namespace analysis
