// SPDX-License-Identifier: MIT
// Directed rounding without touching the processor's rounding mode: results rounded to nearest are
// moved outwards by as much as they may be wrong. Ends may be infinite; NaN must not come in.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace numeric {

/// The next larger double; +infinity and NaN stay. Both zeros count as one number.
inline double next_up(double x) {
    if (x == 0) return std::numeric_limits<double>::denorm_min();
    if (x == std::numeric_limits<double>::infinity()) return x;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    return std::bit_cast<double>(x > 0 ? bits + 1 : bits - 1);
}

/// The next smaller double; -infinity stays.
inline double next_down(double x) { return -next_up(-x); }

/// The same for finite numbers other than 0, without a branch.
inline double next_down_from_nonzero(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    return std::bit_cast<double>(bits - 1 + 2 * (bits >> 63));  // a negative number grows in size
}
inline double next_up_from_nonzero(double x) { return -next_down_from_nonzero(-x); }

/// `steps` doubles further up or down.
inline double steps_up(double x, int steps) {
    for (int i = 0; i < steps; ++i) x = next_up(x);
    return x;
}
inline double steps_down(double x, int steps) { return -steps_up(-x, steps); }

/// The largest double <= a + b, given that sum rounded to nearest, which is finite; or one below it
/// near overflow.
inline double sum_down(double a, double b, double sum) {
    // Knuth's TwoSum: sum + error is a + b exactly, unless something overflows; then it is NaN. A
    // sum of 0 is exact. There is no branch, for the sides alternate at random.
    const double part = sum - a;
    const double error = (a - (sum - part)) + (b - part);
    const double below = next_down_from_nonzero(sum);
    return error >= 0 ? sum : below;
}
/// The largest double <= a + b, or one below it near overflow. NaN for infinities that cancel.
inline double add_down(double a, double b) {
    const double sum = a + b;
    return std::isfinite(sum) ? sum_down(a, b, sum) : next_down(sum);
}
inline double add_up(double a, double b) { return -add_down(-a, -b); }

/// A double <= a * b, at most two below the exact product; exact for a factor 0, also 0 * infinity.
inline double mul_down(double a, double b) {
    if (a == 0 || b == 0) return 0;
    const double product = a * b;
    if (product == 0) {  // underflow
        return (a < 0) == (b < 0) ? 0 : -std::numeric_limits<double>::denorm_min();
    }
    return next_down(product);
}
inline double mul_up(double a, double b) { return -mul_down(-a, b); }

/// A double <= a / b for b != 0, at most two below the exact quotient; exact for a = 0. NaN for two
/// infinities.
inline double div_down(double a, double b) {
    if (a == 0) return 0;
    const double quotient = a / b;
    if (std::isnan(quotient)) return quotient;
    if (quotient == 0) {
        return (a < 0) == (b < 0) ? 0 : -std::numeric_limits<double>::denorm_min();
    }
    return next_down(quotient);
}
inline double div_up(double a, double b) { return -div_down(-a, b); }

}  // namespace numeric
