// SPDX-License-Identifier: MIT
// Quaternions a + bi + cj + dk of graph nodes. Internal to the library.
#pragma once

#include "graph/build.h"

namespace formula {

struct Quaternion {
    graph::Expr a, b, c, d;
};

/// Hamilton's product: ij = k, jk = i, ki = j.
Quaternion operator*(const Quaternion& p, const Quaternion& q);
/// p q^-1
Quaternion operator/(const Quaternion& p, const Quaternion& q);
Quaternion conjugate(const Quaternion& q);
Quaternion inverse(const Quaternion& q);

/// q^n for n >= 1, by squaring. All powers of q lie in the plane of 1 and q, so that one costs what
/// a complex power costs, and three products.
Quaternion whole_power(const Quaternion& q, int n);

/// The principal value of q^n: the length to the power n, the angle to the real axis (0 to pi)
/// times n, the axis kept. Real numbers below 0, whose axis is not defined, answer as if it were 0.
Quaternion real_power(const Quaternion& q, graph::Expr n);

}  // namespace formula
