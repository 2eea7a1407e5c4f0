// SPDX-License-Identifier: MIT
// Arithmetic with balls of quaternions. Internal to the library.
#pragma once

#include <array>
#include <cmath>

#include "numeric/interval.h"

namespace oracle {

/// All quaternions (real part first) within `radius` of a centre; where either is not finite, all.
/// What the functions below return holds all exact results of members: the norm of quaternions is
/// multiplicative, so |ab + ba| <= 2 |a| |b|, and balls do not grow by being turned as boxes do.
/// Rounding to nearest is assumed; it is covered by the radius.
struct QuaternionBall {
    std::array<double, 4> centre{};
    double radius = 0;
};

/// More than the exact value of a short expression of positive numbers that was rounded to a.
inline double rounded_up(double a) { return a * (1 + 0x1p-48) + 1e-300; }

/// At least |centre|.
inline double centre_length(const QuaternionBall& a) {
    const auto& [w, x, y, z] = a.centre;
    return rounded_up(std::sqrt(w * w + x * x + y * y + z * z));
}

inline QuaternionBall sum(const QuaternionBall& a, const QuaternionBall& b) {
    QuaternionBall result;
    for (std::size_t i = 0; i < 4; ++i) result.centre[i] = a.centre[i] + b.centre[i];
    const double rounding = 0x1p-52 * (centre_length(a) + centre_length(b));
    result.radius = rounded_up(a.radius + b.radius + rounding);
    return result;
}

/// q^2.
inline QuaternionBall square(const QuaternionBall& q) {
    const auto& [w, x, y, z] = q.centre;
    QuaternionBall result{{w * w - (x * x + y * y + z * z), 2 * w * x, 2 * w * y, 2 * w * z}};
    // Rounded are at most 4 terms of the first part, whose sizes add up to |q|^2, and the others
    // once.
    const double length = centre_length(q);
    result.radius = rounded_up((2 * length + q.radius) * q.radius + 0x1p-50 * length * length);
    return result;
}

/// a b + b a.
inline QuaternionBall products(const QuaternionBall& a, const QuaternionBall& b) {
    const auto &p = a.centre, &q = b.centre;
    QuaternionBall result;
    result.centre[0] = 2 * (p[0] * q[0] - (p[1] * q[1] + p[2] * q[2] + p[3] * q[3]));
    for (std::size_t i = 1; i < 4; ++i) result.centre[i] = 2 * (p[0] * q[i] + q[0] * p[i]);
    const double m = centre_length(a), n = centre_length(b);
    result.radius =
        rounded_up(2 * (m * b.radius + n * a.radius + a.radius * b.radius) + 0x1p-49 * m * n);
    return result;
}

/// The smallest that is easy to have around a box.
inline QuaternionBall ball_around(const std::array<numeric::Interval, 4>& box) {
    QuaternionBall ball;
    double squares = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const double middle = box[i].lo + 0.5 * (box[i].hi - box[i].lo);
        const double half = rounded_up(std::max(box[i].hi - middle, middle - box[i].lo));
        ball.centre[i] = middle;
        if (!box[i].is_point()) squares += half * half;
    }
    ball.radius = squares > 0 ? rounded_up(std::sqrt(squares)) : 0;
    return ball;
}

inline bool is_bounded(const QuaternionBall& a) {
    return std::isfinite(centre_length(a)) && std::isfinite(a.radius);
}

/// What |q|^2 may be.
inline numeric::Interval norm(const QuaternionBall& q) {
    if (!is_bounded(q)) return {0, numeric::infinity};
    const double length = centre_length(q);
    const double least = length * (1 - 0x1p-46) - q.radius, most = length + q.radius;
    return {least > 0 ? least * least * (1 - 0x1p-48) : 0, rounded_up(most * most)};
}

/// What the inner product of members may be.
inline numeric::Interval inner_product(const QuaternionBall& a, const QuaternionBall& b) {
    if (!is_bounded(a) || !is_bounded(b)) return numeric::Interval::whole();
    const auto &p = a.centre, &q = b.centre;
    const double middle = p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3];
    const double m = centre_length(a), n = centre_length(b);
    const double radius =
        rounded_up(m * b.radius + n * a.radius + a.radius * b.radius + 0x1p-50 * m * n);
    return numeric::Interval(middle) + numeric::Interval(-radius, radius);
}

}  // namespace oracle
