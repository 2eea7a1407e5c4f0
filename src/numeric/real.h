// SPDX-License-Identifier: MIT
// The operators of graph/operators.def for double. Out of the domain the value is NaN, and NaN goes
// through every operator, also through those of which C lets it vanish (min, pow, hypot).
#pragma once

#include <cmath>
#include <limits>

namespace numeric {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

inline double neg(double a) { return -a; }
inline double add(double a, double b) { return a + b; }
inline double sub(double a, double b) { return a - b; }
inline double mul(double a, double b) { return a * b; }
/// As IEEE 754: an infinity at a pole, NaN for 0 / 0.
inline double div(double a, double b) { return a / b; }
inline double square(double a) { return a * a; }

/// True for -3, 0, 1e300; false for 0.5, infinities and NaN.
inline bool is_whole(double a) { return std::isfinite(a) && std::floor(a) == a; }

/// As std::pow, but NaN wherever an argument is NaN, and for a negative base under an exponent that
/// is not whole (infinite ones included).
inline double pow(double a, double b) {
    if (std::isnan(a) || std::isnan(b) || (a < 0 && !is_whole(b))) return not_a_number;
    return std::pow(a, b);
}
inline double sqrt(double a) { return std::sqrt(a); }
inline double cbrt(double a) { return std::cbrt(a); }
/// sqrt(a^2 + b^2) without overflow on the way.
inline double hypot(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return not_a_number;
    return std::hypot(a, b);
}
/// sqrt(a^2 + b^2 + c^2) without overflow on the way.
inline double hypot3(double a, double b, double c) { return hypot(hypot(a, b), c); }

inline double sin(double a) { return std::sin(a); }
inline double cos(double a) { return std::cos(a); }
inline double tan(double a) { return std::tan(a); }
inline double asin(double a) { return std::asin(a); }
inline double acos(double a) { return std::acos(a); }
inline double atan(double a) { return std::atan(a); }
/// The angle of (b, a) in (-pi, pi], whatever the signs of zeros; 0 at the origin.
inline double atan2(double a, double b) {
    return std::atan2(a + 0.0, b + 0.0);  // -0 + 0 is 0
}
inline double sinh(double a) { return std::sinh(a); }
inline double cosh(double a) { return std::cosh(a); }
inline double tanh(double a) { return std::tanh(a); }
inline double exp(double a) { return std::exp(a); }
/// Natural; 0 is out of the domain like the negative numbers.
inline double log(double a) { return a > 0 ? std::log(a) : not_a_number; }

inline double abs(double a) { return std::abs(a); }
/// -1, 0 or 1.
inline double sign(double a) {
    if (std::isnan(a)) return not_a_number;
    return static_cast<double>((a > 0) - (a < 0));
}
inline double floor(double a) { return std::floor(a); }
inline double ceil(double a) { return std::ceil(a); }
inline double min(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return not_a_number;
    return b < a ? b : a;
}
inline double max(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return not_a_number;
    return a < b ? b : a;
}
/// a / b where |a| <= b is known up to rounding: 0 for 0 / 0, never beyond -1 and 1.
inline double ratio(double a, double b) {
    if (a == 0 && b == 0) return 0;
    return max(-1.0, min(1.0, a / b));
}
/// a < b ? c : d; NaN if a or b is. The branch that is not taken does not matter.
inline double select_less(double a, double b, double c, double d) {
    if (std::isnan(a) || std::isnan(b)) return not_a_number;
    return a < b ? c : d;
}

}  // namespace numeric
