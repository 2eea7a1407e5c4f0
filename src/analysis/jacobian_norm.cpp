// SPDX-License-Identifier: MIT
#include "analysis/jacobian_norm.h"

#include <algorithm>
#include <cmath>

#include "analysis/evaluator.h"
#include "analysis/spectral_norm.h"
#include "numeric/jet.h"

namespace analysis {
namespace {

using numeric::Dual;
using numeric::Interval;

/// Far more than the rounding errors of a few dozen operations.
constexpr double rounding_allowance = 1 + 1e-12;

template <class T, class U, class Map>
Matrix<T> mapped(const Matrix<U>& a, Map entry) {
    Matrix<T> result{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) result[i][k] = entry(a[i][k]);
    }
    return result;
}

double largest_entry(const Matrix<double>& a) {
    double largest = 0;
    for (const auto& row : a) {
        for (const double entry : row) largest = std::max(largest, std::abs(entry));
    }
    return largest;
}

/// A^T A.
Symmetric<double> gram(const Matrix<double>& a) {
    const auto columns = [&](std::size_t i, std::size_t k) {
        return a[0][i] * a[0][k] + a[1][i] * a[1][k] + a[2][i] * a[2][k];
    };
    return {.xx = columns(0, 0),
            .yy = columns(1, 1),
            .zz = columns(2, 2),
            .xy = columns(0, 1),
            .xz = columns(0, 2),
            .yz = columns(1, 2)};
}

double middle(const Interval& i) { return i.is_empty() ? 0 : 0.5 * i.lo + 0.5 * i.hi; }
double radius(const Interval& i) {
    if (i.is_empty()) return 0;
    const double m = middle(i);
    return std::max(numeric::add_up(i.hi, -m), numeric::add_up(m, -i.lo));
}

/// The matrix of jacobian_norm_bound.
template <class T>
Matrix<T> jacobian(std::span<const Dual<T>> roots) {
    Matrix<T> a{roots[0].gradient, roots[1].gradient, roots[2].gradient};
    if (roots.size() < 4) return a;
    const std::array<T, 3>& turn = roots[3].gradient;
    for (std::size_t k = 0; k < 3; ++k) {
        a[0][k] = numeric::add(a[0][k], numeric::mul(roots[1].value, turn[k]));
        a[1][k] = numeric::sub(a[1][k], numeric::mul(roots[0].value, turn[k]));
    }
    return a;
}

bool breaks(const Dual<Interval>& f) { return f.value.partial || f.value.jumps; }
/// Nothing is known of a derivative that may be undefined where the map is not.
bool is_unknown(const Interval& d) { return d.is_empty() || d.partial; }

double norm_over(std::span<const Dual<Interval>> roots) {
    if (std::ranges::any_of(roots, breaks)) return numeric::infinity;
    for (const Dual<Interval>& root : roots) {
        if (std::ranges::any_of(root.gradient, is_unknown)) return numeric::infinity;
    }
    return stretch_bound(jacobian(roots));
}

}  // namespace

double stretch_bound(const Matrix<double>& a) {
    // Scaled to entries of at most 1, so that their squares neither overflow nor vanish.
    const double scale = largest_entry(a);
    if (scale == 0) return 0;
    if (!std::isfinite(scale)) return numeric::infinity;
    const Matrix<double> unit = mapped<double>(a, [&](double entry) { return entry / scale; });
    return scale * std::sqrt(spectral_norm_bound(gram(unit))) * rounding_allowance;
}

double stretch_bound(const Matrix<Interval>& a) {
    const Matrix<double> magnitudes =
        mapped<double>(a, [](const Interval& i) { return magnitude(i); });
    if (!std::isfinite(largest_entry(magnitudes))) return numeric::infinity;
    // As for symmetric matrices: absolute values, or the triangle inequality for middle and radius.
    const double by_signs =
        (stretch_bound(mapped<double>(a, middle)) + stretch_bound(mapped<double>(a, radius))) *
        rounding_allowance;
    return std::min(stretch_bound(magnitudes), by_signs);
}

double jacobian_norm_bound(const eval::Tape& map, const Region& region,
                           std::span<const double> parameters, const Effort& effort) {
    RootEvaluator<Dual<Interval>> over(map, parameters);
    RootEvaluator<Dual<double>> at(map, parameters);
    return supremum_bound(region, effort, [&](const Cell& cell) {
        const double upper = norm_over(over(with_slopes(cell.sides())));
        const double norm = stretch_bound(jacobian(at(with_slopes(coordinates(cell.middle())))));
        // The bound is above the norm by 2 % at most.
        return CellBounds{upper, std::isfinite(norm) ? 0.98 * norm : 0};
    });
}

}  // namespace analysis
