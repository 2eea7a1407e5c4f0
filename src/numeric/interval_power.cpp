// SPDX-License-Identifier: MIT
// Powers, roots and lengths of intervals.
#include <algorithm>

#include "numeric/interval.h"

namespace numeric {
namespace {

// Doubles to move outwards: twice the largest known errors of glibc (pow and hypot 1 ulp, cbrt 4),
// so that the exact value and the value at any double within are both enclosed.
constexpr int pow_steps = 2;
constexpr int hypot_steps = 2;
constexpr int hypot3_steps = 6;
constexpr int cbrt_steps = 8;

/// Moves a bound of something that is not negative down, and a computed 0 of arguments that are not
/// 0 stays a bound too.
double not_negative_down(double x, int steps) { return std::max(0.0, steps_down(x, steps)); }

bool is_exact(double base, double exponent) {
    return exponent == 1 || exponent == 0 || base == 0 || base == 1;
}

/// For base >= 0. Squares are common, and a product is much faster than std::pow and no less
/// accurate. A base of -0 must not turn the sign of a pole.
double nearest_pow(double base, double exponent) {
    return exponent == 2 ? base * base : std::pow(base + 0.0, exponent);
}

double pow_down(double base, double exponent) {
    const double value = nearest_pow(base, exponent);
    return is_exact(base, exponent) ? value : not_negative_down(value, pow_steps);
}
double pow_up(double base, double exponent) {
    const double value = nearest_pow(base, exponent);
    return is_exact(base, exponent) ? value : steps_up(value, pow_steps);
}

/// base^exponent for 0 <= base: x^y is monotone in x for each y and in y for each x, so that the
/// corners hold the extrema.
Interval corners(double base_lo, double base_hi, const Interval& exponent) {
    double lo = infinity, hi = 0;
    for (const double base : {base_lo, base_hi}) {
        for (const double power : {exponent.lo, exponent.hi}) {
            lo = std::min(lo, pow_down(base, power));
            hi = std::max(hi, pow_up(base, power));
        }
    }
    return {lo, hi};
}

/// a^n for whole n >= 1.
Interval positive_whole_power(const Interval& a, double n) {
    const bool even = std::fmod(n, 2) == 0;
    if (even || a.lo >= 0) return {pow_down(mignitude(a), n), pow_up(magnitude(a), n)};
    const double lo = -pow_up(-a.lo, n);
    const double hi = a.hi >= 0 ? pow_up(a.hi, n) : -pow_down(-a.hi, n);
    return {lo, hi};
}

/// a^-n for whole n >= 1; partial where a has 0.
Interval negative_whole_power(const Interval& a, double n) {
    const bool even = std::fmod(n, 2) == 0;
    if (even || a.lo >= 0) {
        if (magnitude(a) == 0) return Interval::empty();  // a pole everywhere
        return {pow_down(magnitude(a), -n), pow_up(mignitude(a), -n), a.contains(0)};
    }
    if (a.hi > 0) return {-infinity, infinity, true};
    return {-pow_up(-a.hi, -n), -pow_down(-a.lo, -n), a.hi == 0};
}

Interval general_power(const Interval& a, const Interval& b) {
    Interval result = Interval::empty();
    if (a.hi >= 0) {
        result = corners(std::max(a.lo, 0.0), a.hi, b);
        // 0^b: a pole for b < 0, and no limit at 0^0.
        const bool only_0 = b.lo == 0 && b.hi == 0;
        result.partial = a.contains(0) && b.lo <= 0 && !only_0;
    }
    if (a.lo < 0) {
        if (std::ceil(b.lo) <= b.hi) {
            const double top = corners(std::max(-a.hi, 0.0), -a.lo, b).hi;
            result = hull(result, {-top, top});
        }
        result.partial = true;
    }
    return result;
}

}  // namespace

Interval pow(const Interval& a, const Interval& b) {
    if (a.is_empty() || b.is_empty()) return Interval::empty();
    Interval result;
    if (!b.is_point() || !is_whole(b.lo)) {
        result = general_power(a, b);
        if (result.is_empty()) return result;
    } else if (b.lo == 0) {
        result = {1, 1};
    } else if (b.lo > 0) {
        result = positive_whole_power(a, b.lo);
    } else {
        result = negative_whole_power(a, -b.lo);
        if (result.is_empty()) return result;
    }
    result.partial = result.partial || a.partial || b.partial;
    result.jumps = a.jumps || b.jumps;
    return result;
}

Interval sqrt(const Interval& a) {
    if (a.is_empty() || a.hi < 0) return Interval::empty();
    // The square root is rounded correctly, so one double is enough; 0 and infinity are exact.
    const double low = a.lo > 0 ? std::sqrt(a.lo) : 0;
    const double high = std::sqrt(a.hi);
    const bool exact_low = low * low == a.lo && low == std::floor(low) && low < 0x1p26;
    const bool exact_high = high * high == a.hi && high == std::floor(high) && high < 0x1p26;
    return {exact_low || low == 0 ? low : next_down(low),
            exact_high || high == 0 ? high : next_up(high), a.partial || a.lo < 0, a.jumps};
}

Interval cbrt(const Interval& a) {
    if (a.is_empty()) return a;
    const auto down = [](double x) {
        if (x == 0) return 0.0;
        const double root = steps_down(std::cbrt(x), cbrt_steps);
        return x > 0 ? std::max(root, 0.0) : root;
    };
    return {down(a.lo), -down(-a.hi), a.partial, a.jumps};
}

Interval hypot(const Interval& a, const Interval& b) {
    if (a.is_empty() || b.is_empty()) return Interval::empty();
    const double low = std::hypot(mignitude(a), mignitude(b));
    const double high = std::hypot(magnitude(a), magnitude(b));
    return {low == 0 ? 0 : not_negative_down(low, hypot_steps),
            high == 0 ? 0 : steps_up(high, hypot_steps), a.partial || b.partial,
            a.jumps || b.jumps};
}

Interval hypot3(const Interval& a, const Interval& b, const Interval& c) {
    if (a.is_empty() || b.is_empty() || c.is_empty()) return Interval::empty();
    const double low = hypot3(mignitude(a), mignitude(b), mignitude(c));
    const double high = hypot3(magnitude(a), magnitude(b), magnitude(c));
    return {low == 0 ? 0 : not_negative_down(low, hypot3_steps),
            high == 0 ? 0 : steps_up(high, hypot3_steps), a.partial || b.partial || c.partial,
            a.jumps || b.jumps || c.jumps};
}

}  // namespace numeric
