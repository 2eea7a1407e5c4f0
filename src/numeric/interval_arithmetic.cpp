// SPDX-License-Identifier: MIT
// The four operations of arithmetic on intervals.
#include <algorithm>

#include "numeric/interval.h"

namespace numeric {
namespace {

bool is_infinite(double x) { return std::isinf(x); }

/// True if an infinity of a may meet a zero of b.
bool infinity_meets_zero(const Interval& a, const Interval& b) {
    return (is_infinite(a.lo) || is_infinite(a.hi)) && b.contains(0);
}

/// a * b by the signs of the arguments, which tell the ends that make the extrema.
Interval product(const Interval& a, const Interval& b) {
    const auto ends = [](double low_1, double low_2, double high_1, double high_2) {
        return Interval{mul_down(low_1, low_2), mul_up(high_1, high_2)};
    };
    if (a.lo >= 0) {
        if (b.lo >= 0) return ends(a.lo, b.lo, a.hi, b.hi);
        if (b.hi <= 0) return ends(a.hi, b.lo, a.lo, b.hi);
        return ends(a.hi, b.lo, a.hi, b.hi);
    }
    if (a.hi <= 0) {
        if (b.lo >= 0) return ends(a.lo, b.hi, a.hi, b.lo);
        if (b.hi <= 0) return ends(a.hi, b.hi, a.lo, b.lo);
        return ends(a.lo, b.hi, a.lo, b.lo);
    }
    if (b.lo >= 0) return ends(a.lo, b.hi, a.hi, b.hi);
    if (b.hi <= 0) return ends(a.hi, b.lo, a.lo, b.lo);
    return {std::min(mul_down(a.lo, b.hi), mul_down(a.hi, b.lo)),
            std::max(mul_up(a.lo, b.lo), mul_up(a.hi, b.hi))};
}

/// a / b where b has no zero.
Interval quotient_by_one_sign(const Interval& a, const Interval& b) {
    double lo = infinity, hi = -infinity;
    for (const double x : {a.lo, a.hi}) {
        for (const double y : {b.lo, b.hi}) {
            const double down = div_down(x, y);
            if (std::isnan(down)) continue;  // two infinities: the other ends enclose it
            lo = std::min(lo, down);
            hi = std::max(hi, div_up(x, y));
        }
    }
    return lo <= hi ? Interval{lo, hi} : Interval::whole();
}

/// a / b where b touches 0 with one end and is otherwise positive.
Interval quotient_by_positive_or_zero(const Interval& a, double b_hi) {
    const double lo = a.lo < 0 ? -infinity : div_down(a.lo, b_hi);
    const double hi = a.hi > 0 ? infinity : div_up(a.hi, b_hi);
    // Infinity by infinity leaves no bound.
    return {std::isnan(lo) ? 0.0 : lo, std::isnan(hi) ? 0.0 : hi};
}

}  // namespace

Interval hull(const Interval& a, const Interval& b) {
    return {std::min(a.lo, b.lo), std::max(a.hi, b.hi), a.partial || b.partial, a.jumps || b.jumps};
}

Interval careful_sum(const Interval& a, const Interval& b) {
    if (a.is_empty() || b.is_empty()) return Interval::empty();
    const double lo = add_down(a.lo, b.lo), hi = add_up(a.hi, b.hi);
    // Where infinities cancel nothing is known.
    const bool cancels =
        (a.hi == infinity && b.lo == -infinity) || (a.lo == -infinity && b.hi == infinity);
    return {std::isnan(lo) ? -infinity : lo, std::isnan(hi) ? infinity : hi,
            a.partial || b.partial || cancels, a.jumps || b.jumps};
}

Interval careful_product(const Interval& a, const Interval& b) {
    if (a.is_empty() || b.is_empty()) return Interval::empty();
    const bool partial =
        a.partial || b.partial || infinity_meets_zero(a, b) || infinity_meets_zero(b, a);
    const bool jumps = a.jumps || b.jumps;
    if (a.is_point() && b.is_point()) {
        // Numbers such as 2 * 3 or 0.5 * n stay single numbers. Above 2^-900 the fused
        // multiplication gives the rounding error exactly.
        const double product = a.lo * b.lo;
        if (std::abs(product) > 0x1p-900 && std::fma(a.lo, b.lo, -product) == 0) {
            return {product, product, partial, jumps};
        }
    }
    Interval result = product(a, b);
    result.partial = partial;
    result.jumps = jumps;
    return result;
}

Interval careful_quotient(const Interval& a, const Interval& b) {
    if (a.is_empty() || b.is_empty()) return Interval::empty();
    Interval result;
    if (!b.contains(0)) {
        result = quotient_by_one_sign(a, b);
        const bool both_infinite =
            (is_infinite(a.lo) || is_infinite(a.hi)) && (is_infinite(b.lo) || is_infinite(b.hi));
        result.partial = both_infinite;
    } else {
        if (b.lo == 0 && b.hi > 0) {
            result = quotient_by_positive_or_zero(a, b.hi);
        } else if (b.hi == 0 && b.lo < 0) {
            result = neg(quotient_by_positive_or_zero(a, -b.lo));
        } else if (b.is_point()) {
            return Interval::empty();  // a pole everywhere
        } else {
            result = Interval::whole();
        }
        result.partial = true;
    }
    result.partial = result.partial || a.partial || b.partial;
    result.jumps = a.jumps || b.jumps;
    return result;
}

}  // namespace numeric
