// SPDX-License-Identifier: MIT
// Operators on intervals that are made of straight or constant pieces: no rounding, but jumps.
#include <algorithm>

#include "numeric/interval.h"

namespace numeric {
namespace {

/// A function that is constant between its jumps and never falls: no jump if both ends agree.
Interval staircase(const Interval& a, double (*step)(double)) {
    if (a.is_empty()) return a;
    const double lo = step(a.lo), hi = step(a.hi);
    return {lo, hi, a.partial, lo != hi};
}

}  // namespace

Interval abs(const Interval& a) {
    if (a.is_empty()) return a;
    return {mignitude(a), magnitude(a), a.partial, a.jumps};
}

Interval sign(const Interval& a) { return staircase(a, sign); }
Interval floor(const Interval& a) { return staircase(a, floor); }
Interval ceil(const Interval& a) { return staircase(a, ceil); }

Interval min(const Interval& a, const Interval& b) {
    if (a.is_empty() || b.is_empty()) return Interval::empty();
    // Jumps of an operand that is never the smaller one do not show.
    const bool jumps = (a.jumps && a.lo <= b.hi) || (b.jumps && b.lo <= a.hi);
    return {std::min(a.lo, b.lo), std::min(a.hi, b.hi), a.partial || b.partial, jumps};
}

Interval max(const Interval& a, const Interval& b) { return neg(min(neg(a), neg(b))); }

Interval ratio(const Interval& a, const Interval& b) {
    if (a.is_empty() || b.is_empty() || b.hi < 0) return Interval::empty();
    const double b_lo = std::max(b.lo, 0.0);
    const bool both_infinite = b.hi == infinity && (a.lo == -infinity || a.hi == infinity);
    const bool partial = a.partial || b.partial || both_infinite;
    const bool jumps = a.jumps || b.jumps || b_lo == 0;
    // |a| <= b leaves only 0 there.
    if (b.hi == 0) return {0, 0, partial, false};
    const auto low_quotient = [](double numerator, double low, double high) {
        const double divisor = numerator >= 0 ? high : low;
        if (divisor == 0) return -1.0;
        const double quotient = div_down(numerator, divisor);
        return std::isnan(quotient) ? -1.0 : std::clamp(quotient, -1.0, 1.0);
    };
    const double lo = low_quotient(a.lo, b_lo, b.hi);
    const double hi = -low_quotient(-a.hi, b_lo, b.hi);
    return {lo, hi, partial, jumps};
}

Interval select_less(const Interval& a, const Interval& b, const Interval& c, const Interval& d) {
    if (a.is_empty() || b.is_empty()) return Interval::empty();
    Interval result;
    if (a.hi < b.lo) {
        result = c;
    } else if (a.lo >= b.hi) {
        result = d;
    } else {
        const bool same = c.is_point() && d.is_point() && c.lo == d.lo;
        result = hull(c, d);
        result.jumps = result.jumps || !same;
    }
    result.partial = result.partial || a.partial || b.partial;
    return result;
}

}  // namespace numeric
