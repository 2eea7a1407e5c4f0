// SPDX-License-Identifier: MIT
// Interval arithmetic with outward rounding: the operators of graph/operators.def on sets of
// numbers.
#pragma once

#include <algorithm>

#include "numeric/real.h"
#include "numeric/rounding.h"

namespace numeric {

/// A closed interval that encloses every value of an expression where that is defined, over a set
/// of arguments. Rigorous: it holds the exact values and those of the operators for double in
/// numeric/real.h, given the accuracy of glibc's functions (docs/numerics.md). The ends are never
/// NaN; an infinite end means that no bound is known or that an infinity may be a value.
///
/// Two facts about the arguments that the ends cannot tell, both conservative ("may"), are carried
/// along: where one is set, nothing follows about the value between two points.
struct Interval {
    double lo = 0;
    double hi = 0;
    bool partial = false;  ///< may be undefined (NaN, or at a pole) somewhere on the arguments
    bool jumps = false;    ///< may be discontinuous somewhere on the arguments

    Interval() = default;
    /// A single number. NaN makes the empty interval.
    Interval(double number) : Interval(number == number ? Interval(number, number) : empty()) {}
    Interval(double low, double high, bool may_be_undefined = false, bool may_jump = false)
        : lo(low), hi(high), partial(may_be_undefined), jumps(may_jump) {}

    /// No value at all: nowhere defined.
    static Interval empty() { return {infinity, -infinity, true, false}; }
    static Interval whole() { return {-infinity, infinity}; }

    bool is_empty() const { return !(lo <= hi); }
    bool is_point() const { return lo == hi; }
    bool contains(double number) const { return lo <= number && number <= hi; }

    friend bool operator==(const Interval&, const Interval&) = default;
};

/// The smallest interval with the values of both, as if the arguments were put together.
Interval hull(const Interval& a, const Interval& b);
/// The largest absolute value, 0 for the empty interval.
inline double magnitude(const Interval& a) {
    if (a.is_empty()) return 0;
    return -a.lo > a.hi ? -a.lo : std::abs(a.hi);
}
/// The smallest absolute value, 0 for the empty interval.
inline double mignitude(const Interval& a) {
    if (a.is_empty() || a.contains(0)) return 0;
    return a.lo > 0 ? a.lo : -a.hi;
}

inline Interval neg(const Interval& a) {
    if (a.is_empty()) return a;
    return {-a.hi, -a.lo, a.partial, a.jumps};
}
/// Sums, products and quotients of all intervals, also of those that are not as usual.
Interval careful_sum(const Interval& a, const Interval& b);
Interval careful_product(const Interval& a, const Interval& b);
Interval careful_quotient(const Interval& a, const Interval& b);

[[gnu::always_inline]] inline Interval add(const Interval& a, const Interval& b) {
    const double lo = a.lo + b.lo, hi = a.hi + b.hi;
    // Not so for infinite and empty arguments.
    if (!std::isfinite(hi - lo)) return careful_sum(a, b);
    return {sum_down(a.lo, b.lo, lo), -sum_down(-a.hi, -b.hi, -hi), a.partial || b.partial,
            a.jumps || b.jumps};
}
inline Interval sub(const Interval& a, const Interval& b) { return add(a, neg(b)); }
[[gnu::always_inline]] inline Interval mul(const Interval& a, const Interval& b) {
    const double p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
    const double lo = std::min(std::min(p, q), std::min(r, s));
    const double hi = std::max(std::max(p, q), std::max(r, s));
    // Infinite and empty arguments make this sum infinite or NaN. An end that is 0 may be exact or
    // rounded, and so may a product of single numbers.
    const bool usual = std::isfinite((p + q) + (r + s)) && lo != 0 && hi != 0 && lo != hi;
    if (!usual) return careful_product(a, b);
    return {next_down_from_nonzero(lo), next_up_from_nonzero(hi), a.partial || b.partial,
            a.jumps || b.jumps};
}
/// Partial where b may be 0: the whole line, or a half-line if b has one sign, or nothing if b is
/// only 0. Signed zeros are not told apart, so that x / -0, an infinity of the other side, is
/// covered by `partial` only.
inline Interval div(const Interval& a, const Interval& b) {
    const double p = a.lo / b.lo, q = a.lo / b.hi, r = a.hi / b.lo, s = a.hi / b.hi;
    const double lo = std::min(std::min(p, q), std::min(r, s));
    const double hi = std::max(std::max(p, q), std::max(r, s));
    // As in a product; and b may be finite, or empty, and of one sign or not.
    const bool usual = std::isfinite((p + q) + (r + s)) && lo != 0 && hi != 0 &&
                       (b.lo > 0 || b.hi < 0) && std::isfinite(b.hi - b.lo);
    if (!usual) return careful_quotient(a, b);
    return {next_down_from_nonzero(lo), next_up_from_nonzero(hi), a.partial || b.partial,
            a.jumps || b.jumps};
}

inline Interval operator-(const Interval& a) { return neg(a); }
inline Interval operator+(const Interval& a, const Interval& b) { return add(a, b); }
inline Interval operator-(const Interval& a, const Interval& b) { return sub(a, b); }
inline Interval operator*(const Interval& a, const Interval& b) { return mul(a, b); }
inline Interval operator/(const Interval& a, const Interval& b) { return div(a, b); }
/// a * a for the same a: never negative.
inline Interval square(const Interval& a) {
    if (a.is_empty()) return a;
    const double low = mignitude(a), high = magnitude(a);
    return {mul_down(low, low), mul_up(high, high), a.partial, a.jumps};
}
/// Where b is a single whole number the power with its own monotone pieces; else negative bases are
/// partial, and count with both signs if b has a whole number.
Interval pow(const Interval& a, const Interval& b);
Interval sqrt(const Interval& a);
Interval cbrt(const Interval& a);
Interval hypot(const Interval& a, const Interval& b);
Interval hypot3(const Interval& a, const Interval& b, const Interval& c);
Interval sin(const Interval& a);
Interval cos(const Interval& a);
Interval tan(const Interval& a);
Interval asin(const Interval& a);
Interval acos(const Interval& a);
Interval atan(const Interval& a);
/// Jumps where the half-line a = 0, b <= 0 may be met, but not where it is only the border from
/// above; at the origin always.
Interval atan2(const Interval& a, const Interval& b);
Interval sinh(const Interval& a);
Interval cosh(const Interval& a);
Interval tanh(const Interval& a);
Interval exp(const Interval& a);
Interval log(const Interval& a);
Interval abs(const Interval& a);
Interval sign(const Interval& a);
Interval floor(const Interval& a);
Interval ceil(const Interval& a);
Interval min(const Interval& a, const Interval& b);
Interval max(const Interval& a, const Interval& b);
/// Within [-1, 1]; jumps where b may be 0. Values of b below 0 do not occur by assumption.
Interval ratio(const Interval& a, const Interval& b);
/// One branch where the comparison is decided, else the hull of both; then it jumps unless both are
/// the same number.
Interval select_less(const Interval& a, const Interval& b, const Interval& c, const Interval& d);

}  // namespace numeric
