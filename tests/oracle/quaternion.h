// SPDX-License-Identifier: MIT
// Quaternions in more digits than double has, real part first.
#pragma once

#include <array>
#include <cmath>

#include <quadmath.h>

namespace oracle {

using Wide = std::array<long double, 4>;
using Exact = std::array<__float128, 4>;

/// a b + b a.
template <class Number>
std::array<Number, 4> anti_commutator(const std::array<Number, 4>& a,
                                      const std::array<Number, 4>& b) {
    std::array<Number, 4> result{2 * (a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3])};
    for (std::size_t i = 1; i < 4; ++i) result[i] = 2 * (a[0] * b[i] + b[0] * a[i]);
    return result;
}

inline long double length(const Wide& a) {
    return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + a[3] * a[3]);
}

inline __float128 length(const Exact& a) {
    return sqrtq(a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + a[3] * a[3]);
}

}  // namespace oracle
