// SPDX-License-Identifier: MIT
// Trigonometric, hyperbolic and exponential functions of intervals. Each end is the function of
// glibc, moved outwards by twice the function's largest known error, so that the exact value and
// the value at any double within are both enclosed.
#include <algorithm>
#include <cstdint>

#include "numeric/interval.h"

namespace numeric {
namespace {

// Largest known errors in ulp: 1 for sin, cos, tan, their inverses, exp and log; 3 for sinh, cosh
// and tanh.
constexpr int common_steps = 2;
constexpr int hyperbolic_steps = 6;

constexpr double half_pi = 0x1.921fb54442d18p+0;  // below pi / 2
const Interval half_pi_interval{half_pi, next_up(half_pi)};
constexpr double pi = 0x1.921fb54442d18p+1;  // below pi
const double pi_up = next_up(pi);

/// Numbers n such that n pi / 2 may lie in the argument, as whole numbers; `many` if they span a
/// whole turn or cannot be told apart any more.
struct Quadrants {
    std::int64_t first = 0, last = 0;
    bool many = false;

    /// True if there is an n in it that is `remainder` modulo `modulus`.
    bool contains(std::int64_t remainder, std::int64_t modulus) const {
        if (many) return true;
        const std::int64_t beyond = (((last - remainder) % modulus) + modulus) % modulus;
        return last - beyond >= first;
    }
};

Quadrants quadrants(const Interval& a) {
    const Interval turns = div({a.lo, a.hi}, half_pi_interval);
    // Above 2^50 quarters the quotient says no more than that.
    if (!(magnitude(turns) < 0x1p50) || turns.hi - turns.lo > 8) return {.many = true};
    return {static_cast<std::int64_t>(std::ceil(turns.lo)),
            static_cast<std::int64_t>(std::floor(turns.hi))};
}

bool has_infinite_end(const Interval& a) { return a.lo == -infinity || a.hi == infinity; }

/// sin and cos: the ends, and 1 and -1 where the quadrants hold the places of the extrema.
Interval wave(const Interval& a, double (*function)(double), int top, int bottom) {
    if (a.is_empty()) return a;
    const bool partial = a.partial || has_infinite_end(a);
    const Quadrants q = quadrants(a);
    if (q.many) return {-1, 1, partial, a.jumps};
    // At 0 both functions are exact.
    const int lo_steps = a.lo == 0 ? 0 : common_steps, hi_steps = a.hi == 0 ? 0 : common_steps;
    const double at_lo = function(a.lo), at_hi = function(a.hi);
    double lo = std::min(steps_down(at_lo, lo_steps), steps_down(at_hi, hi_steps));
    double hi = std::max(steps_up(at_lo, lo_steps), steps_up(at_hi, hi_steps));
    if (q.contains(top, 4)) hi = 1;
    if (q.contains(bottom, 4)) lo = -1;
    return {std::max(lo, -1.0), std::min(hi, 1.0), partial, a.jumps};
}

/// An end of an increasing odd function that is 0 at 0 only.
double odd_down(double x, double (*function)(double), int steps) {
    if (x == 0) return 0;
    const double value = steps_down(function(x), steps);
    return x > 0 ? std::max(value, 0.0) : value;
}

Interval increasing_odd(const Interval& a, double (*function)(double), int steps) {
    if (a.is_empty()) return a;
    return {odd_down(a.lo, function, steps), -odd_down(-a.hi, function, steps), a.partial, a.jumps};
}

/// Cuts the argument to [-1, 1].
Interval clip_to_unit(const Interval& a) {
    if (a.is_empty() || a.hi < -1 || a.lo > 1) return Interval::empty();
    return {std::max(a.lo, -1.0), std::min(a.hi, 1.0), a.partial || a.lo < -1 || a.hi > 1, a.jumps};
}

}  // namespace

Interval sin(const Interval& a) { return wave(a, sin, 1, 3); }
Interval cos(const Interval& a) { return wave(a, cos, 0, 2); }

Interval tan(const Interval& a) {
    if (a.is_empty()) return a;
    if (quadrants(a).contains(1, 2)) return {-infinity, infinity, true, a.jumps};
    if (a.lo == 0 && a.hi == 0) return a;
    return {steps_down(std::tan(a.lo), common_steps), steps_up(std::tan(a.hi), common_steps),
            a.partial, a.jumps};
}

Interval asin(const Interval& a) { return increasing_odd(clip_to_unit(a), asin, common_steps); }

Interval acos(const Interval& a) {
    const Interval c = clip_to_unit(a);
    if (c.is_empty()) return c;
    const double lo = c.hi == 1 ? 0 : steps_down(std::acos(c.hi), common_steps);
    const double hi = c.lo == 1 ? 0 : steps_up(std::acos(c.lo), common_steps);
    return {std::max(lo, 0.0), std::min(hi, pi_up), c.partial, c.jumps};
}

Interval atan(const Interval& a) { return increasing_odd(a, atan, common_steps); }

Interval atan2(const Interval& a, const Interval& b) {
    if (a.is_empty() || b.is_empty()) return Interval::empty();
    const bool partial = a.partial || b.partial;
    const bool jumps = a.jumps || b.jumps;
    const bool origin = a.contains(0) && b.contains(0);
    // The cut belongs to the side above it, where the angle is pi.
    if (a.lo < 0 && a.hi >= 0 && b.lo < 0) return {-pi_up, pi_up, partial, true};
    if (a.is_point() && a.lo == 0) {
        return {b.hi >= 0 ? 0 : pi, b.lo < 0 ? pi_up : 0, partial, jumps || origin};
    }
    if (origin) {
        const double lo = a.lo < 0 ? -next_up(half_pi) : 0;
        const double hi = b.lo < 0 ? pi_up : (a.hi > 0 ? next_up(half_pi) : 0);
        return {lo, hi, partial, true};
    }
    double lo = infinity, hi = -infinity;
    for (const double y : {a.lo, a.hi}) {
        for (const double x : {b.lo, b.hi}) {
            const double angle = atan2(y, x);
            const bool exact = angle == 0 && y == 0;
            lo = std::min(lo, exact ? 0 : steps_down(angle, common_steps));
            hi = std::max(hi, exact ? 0 : steps_up(angle, common_steps));
        }
    }
    if (a.lo >= 0) lo = std::max(lo, 0.0);
    if (a.hi <= 0) hi = std::min(hi, 0.0);
    return {std::max(lo, -pi_up), std::min(hi, pi_up), partial, jumps};
}

Interval sinh(const Interval& a) { return increasing_odd(a, sinh, hyperbolic_steps); }

Interval cosh(const Interval& a) {
    if (a.is_empty()) return a;
    const double low = mignitude(a), high = magnitude(a);
    const double lo = steps_down(std::cosh(low), hyperbolic_steps);
    const double hi = high == 0 ? 1 : steps_up(std::cosh(high), hyperbolic_steps);
    return {std::max(lo, 1.0), hi, a.partial, a.jumps};
}

Interval tanh(const Interval& a) {
    Interval result = increasing_odd(a, tanh, hyperbolic_steps);
    if (result.is_empty()) return result;
    result.lo = std::max(result.lo, -1.0);
    result.hi = std::min(result.hi, 1.0);
    return result;
}

Interval exp(const Interval& a) {
    if (a.is_empty()) return a;
    const double lo = a.lo == 0 ? 1 : steps_down(std::exp(a.lo), common_steps);
    const double hi = a.hi == 0 ? 1 : steps_up(std::exp(a.hi), common_steps);
    return {std::max(lo, 0.0), a.hi == -infinity ? 0 : hi, a.partial, a.jumps};
}

Interval log(const Interval& a) {
    if (a.is_empty() || a.hi <= 0) return Interval::empty();
    const auto down = [](double x) {
        if (x <= 0) return -infinity;
        return x == 1 ? 0 : steps_down(std::log(x), common_steps);
    };
    const double hi = a.hi == 1 ? 0 : steps_up(std::log(a.hi), common_steps);
    return {down(a.lo), hi, a.partial || a.lo <= 0, a.jumps};
}

}  // namespace numeric
