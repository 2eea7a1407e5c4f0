// SPDX-License-Identifier: MIT
// Arithmetic with balls of quaternions. Internal to the library.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "numeric/interval.h"

namespace oracle {

/// The largest error of one rounding, as a part of the result.
template <class Real>
constexpr double rounding_part = 0.5 * std::numeric_limits<Real>::epsilon();

/// More than the exact value of a short expression of positive numbers that was rounded to a.
inline double rounded_up(double a) { return a * (1 + 0x1p-48) + 1e-300; }

inline std::array<double, 4> rounded(const std::array<long double, 4>& a) {
    return {static_cast<double>(a[0]), static_cast<double>(a[1]), static_cast<double>(a[2]),
            static_cast<double>(a[3])};
}
inline const std::array<double, 4>& rounded(const std::array<double, 4>& a) { return a; }

/// At least |a|, and little more.
template <class Real>
double length_of(const std::array<Real, 4>& a) {
    const auto& [w, x, y, z] = rounded(a);
    return rounded_up(std::sqrt(w * w + x * x + y * y + z * z));
}

/// All quaternions (real part first) within a radius of a centre, whose components are of type
/// Real; where either is not finite, all. What the functions below return holds all exact results
/// of members: the norm of quaternions is multiplicative, so |ab + ba| <= 2 |a| |b|, and balls do
/// not grow by being turned as boxes do. Rounding to nearest is assumed; it is covered by the
/// radius.
template <class Real>
struct QuaternionBall {
    std::array<Real, 4> centre{};
    double radius = 0;
    double length = length_of(centre);  ///< by `length_of`
};

template <class Real>
QuaternionBall<Real> sum(const QuaternionBall<Real>& a, const QuaternionBall<Real>& b) {
    if (b.length + b.radius < 1e-299) return {a.centre, rounded_up(a.radius + 1e-299), a.length};
    const auto &p = a.centre, &q = b.centre;
    const double rounding = 2 * rounding_part<Real> * (a.length + b.length);
    return {{p[0] + q[0], p[1] + q[1], p[2] + q[2], p[3] + q[3]},
            rounded_up(a.radius + b.radius + rounding)};
}

/// q^2.
template <class Real>
QuaternionBall<Real> square(const QuaternionBall<Real>& q) {
    const auto& [w, x, y, z] = q.centre;
    const double m = q.length, r = q.radius;
    // Rounded are at most 4 terms of the first part, whose sizes add up to |q|^2, and the others
    // once.
    return {{w * w - (x * x + y * y + z * z), 2 * w * x, 2 * w * y, 2 * w * z},
            rounded_up((2 * m + r) * r + 8 * rounding_part<Real> * m * m)};
}

/// a b + b a, in double.
template <class Real>
QuaternionBall<double> products(const QuaternionBall<Real>& a, const QuaternionBall<double>& b) {
    const auto &p = rounded(a.centre), &q = b.centre;
    std::array<double, 4> centre;
    centre[0] = 2 * (p[0] * q[0] - (p[1] * q[1] + p[2] * q[2] + p[3] * q[3]));
    for (std::size_t i = 1; i < 4; ++i) centre[i] = 2 * (p[0] * q[i] + q[0] * p[i]);
    const double m = a.length, n = b.length;
    return {centre,
            rounded_up(2 * (m * b.radius + n * a.radius + a.radius * b.radius) + 0x1p-49 * m * n)};
}

/// The smallest that is easy to have around a box.
template <class Real>
QuaternionBall<Real> ball_around(const std::array<numeric::Interval, 4>& box) {
    std::array<Real, 4> centre;
    double squares = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const double middle = box[i].lo + 0.5 * (box[i].hi - box[i].lo);
        const double half = rounded_up(std::max(box[i].hi - middle, middle - box[i].lo));
        centre[i] = middle;
        if (!box[i].is_point()) squares += half * half;
    }
    return {centre, squares > 0 ? rounded_up(std::sqrt(squares)) : 0};
}

template <class Real>
bool is_bounded(const QuaternionBall<Real>& a) {
    return std::isfinite(a.length) && std::isfinite(a.radius);
}

/// What |q|^2 may be.
template <class Real>
numeric::Interval norm(const QuaternionBall<Real>& q) {
    if (!is_bounded(q)) return {0, numeric::infinity};
    const double least = q.length * (1 - 0x1p-46) - q.radius, most = q.length + q.radius;
    return {least > 0 ? least * least * (1 - 0x1p-48) : 0, rounded_up(most * most)};
}

/// What the inner product of members may be.
template <class Real>
numeric::Interval inner_product(const QuaternionBall<Real>& a, const QuaternionBall<double>& b) {
    if (!is_bounded(a) || !is_bounded(b)) return numeric::Interval::whole();
    const auto &p = rounded(a.centre), &q = b.centre;
    const double middle = p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3];
    const double m = a.length, n = b.length;
    const double radius =
        rounded_up(m * b.radius + n * a.radius + a.radius * b.radius + 0x1p-50 * m * n);
    return numeric::Interval(middle) + numeric::Interval(-radius, radius);
}

}  // namespace oracle
