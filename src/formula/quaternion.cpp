// SPDX-License-Identifier: MIT
#include "formula/quaternion.h"

#include <optional>

namespace formula {
namespace {

using graph::Expr;

/// The square of the length of the imaginary part.
Expr imaginary(const Quaternion& q) { return q.b * q.b + q.c * q.c + q.d * q.d; }

Expr squared_length(const Quaternion& q) { return q.a * q.a + imaginary(q); }

/// re + im v, where v is the imaginary part of a quaternion, v^2 = -square. No `im` is 1.
struct InPlane {
    Expr re;
    std::optional<Expr> im{};
};

InPlane power_in_plane(Expr a, Expr square, int n) {
    if (n == 1) return {a};
    const auto [re, im] = power_in_plane(a, square, n / 2);
    const Expr half = 2.0 * re;
    const InPlane even{re * re - (im ? square * (*im * *im) : square), im ? half * *im : half};
    if (n % 2 == 0) return even;
    return {even.re * a - square * *even.im, even.re + *even.im * a};
}

}  // namespace

Quaternion operator*(const Quaternion& p, const Quaternion& q) {
    return {p.a * q.a - p.b * q.b - p.c * q.c - p.d * q.d,
            p.a * q.b + p.b * q.a + p.c * q.d - p.d * q.c,
            p.a * q.c - p.b * q.d + p.c * q.a + p.d * q.b,
            p.a * q.d + p.b * q.c - p.c * q.b + p.d * q.a};
}

Quaternion conjugate(const Quaternion& q) { return {q.a, -q.b, -q.c, -q.d}; }

Quaternion operator/(const Quaternion& p, const Quaternion& q) {
    const Quaternion product = p * conjugate(q);
    const Expr square = squared_length(q);
    return {product.a / square, product.b / square, product.c / square, product.d / square};
}

Quaternion inverse(const Quaternion& q) {
    const Expr square = squared_length(q);
    return {q.a / square, -q.b / square, -q.c / square, -q.d / square};
}

Quaternion whole_power(const Quaternion& q, int n) {
    if (n == 1) return q;
    const auto [re, im] = power_in_plane(q.a, imaginary(q), n);
    return {re, *im * q.b, *im * q.c, *im * q.d};
}

Quaternion real_power(const Quaternion& q, Expr n) {
    const Expr length = sqrt(squared_length(q));
    const Expr angle = n * acos(ratio(q.a, length));
    const Expr power = pow(length, n);
    const Expr axis = hypot(q.b, q.c, q.d);
    const Expr around = power * sin(angle);
    return {power * cos(angle), around * ratio(q.b, axis), around * ratio(q.c, axis),
            around * ratio(q.d, axis)};
}

}  // namespace formula
