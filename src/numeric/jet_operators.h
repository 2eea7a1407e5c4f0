// SPDX-License-Identifier: MIT
// The operators of graph/operators.def on jets: of each its value and its first and second
// derivatives, once for all kinds of numbers.
#pragma once

#include "numeric/jet.h"

namespace numeric {

/// True if a number may be exactly this one.
inline bool may_be(double a, double number) { return a == number; }
inline bool may_be(const Interval& a, double number) { return a.contains(number); }
/// True if a number is 0 for sure.
inline bool is_zero(double a) { return a == 0; }
inline bool is_zero(const Interval& a) { return a.lo == 0 && a.hi == 0; }

/// The jet without a claim to be smooth, if it is at a kink.
template <AnyJet J>
J with_kink(J jet, bool kink) {
    jet.smooth = jet.smooth && !kink;
    return jet;
}

// Arithmetic.

template <AnyJet J>
J neg(const J& a) {
    return compose_linear(a, neg(a.value), [](const auto& d) { return neg(d); });
}

/// a + b, or a - b if `turn` is neg.
template <AnyJet J, class Turn>
J sum(const J& a, const J& b, const typename J::Number& value, Turn turn) {
    J result = compose_linear(a, value, [](const auto& d) { return d; });
    result.smooth = result.smooth && b.smooth;
    for (int i = 0; i < J::size; ++i) {
        if (!b.has_slope(i)) continue;
        const auto d = turn(b.slope(i));
        result.set_slope(i, a.has_slope(i) ? a.slope(i) + d : d);
    }
    for (int place = 0; place < static_cast<int>(b.hessian.size()); ++place) {
        if (!b.has_bend(place)) continue;
        const auto d = turn(b.bend(place));
        result.set_bend(place, a.has_bend(place) ? a.bend(place) + d : d);
    }
    return result;
}

template <AnyJet J>
J add(const J& a, const J& b) {
    return sum(a, b, a.value + b.value, [](const auto& d) { return d; });
}

template <AnyJet J>
J sub(const J& a, const J& b) {
    return sum(a, b, a.value - b.value, [](const auto& d) { return neg(d); });
}

template <AnyJet J>
J mul(const J& a, const J& b) {
    J result(a.value * b.value);
    result.smooth = a.smooth && b.smooth && is_regular(result.value);
    for (int i = 0; i < J::size; ++i) {
        Sum<typename J::Number> slope;
        if (a.has_slope(i)) slope.add(a.slope(i) * b.value);
        if (b.has_slope(i)) slope.add(b.slope(i) * a.value);
        if (slope.any) result.set_slope(i, slope.total);
    }
    if constexpr (J::has_hessian) {
        for_each_pair<J::size>([&](int i, int j, int place) {
            Sum<typename J::Number> bend = product_of_slopes(a, b, false, i, j);
            if (a.has_bend(place)) bend.add(a.bend(place) * b.value);
            if (b.has_bend(place)) bend.add(b.bend(place) * a.value);
            if (bend.any) result.set_bend(place, bend.total);
        });
    }
    return result;
}

template <AnyJet J>
J square(const J& a) {
    using T = typename J::Number;
    return compose(a, square(a.value), 2.0 * a.value, [] { return T(2.0); });
}

/// The derivatives of a / b and of the operator `ratio`, whose value it is.
template <AnyJet J>
J quotient(const J& a, const J& b, const typename J::Number& value) {
    using T = typename J::Number;
    if (b.is_constant()) {
        return with_kink(compose_linear(a, value, [&](const T& d) { return d / b.value; }),
                         !b.smooth || (!a.is_constant() && may_be(b.value, 0)));
    }
    const T inverse = 1.0 / b.value;
    if (a.is_constant()) {
        return with_kink(
            compose(b, value, neg(value * inverse), [&] { return 2.0 * value * square(inverse); }),
            !a.smooth);
    }
    return compose(std::array{&a, &b}, value, std::array<T, 2>{inverse, neg(value * inverse)}, [&] {
        const T square_of_inverse = square(inverse);
        return std::array<T, 3>{T(0.0), neg(square_of_inverse), 2.0 * value * square_of_inverse};
    });
}

template <AnyJet J>
J div(const J& a, const J& b) {
    return quotient(a, b, a.value / b.value);
}
/// Without derivatives where b is 0, and so a too.
template <AnyJet J>
J ratio(const J& a, const J& b) {
    const auto value = ratio(a.value, b.value);
    if (!is_zero(b.value)) return quotient(a, b, value);
    return with_kink(J(value), !a.smooth || !b.is_constant());
}

// Powers, roots and lengths.

/// a^exponent for an exponent that depends on no variable.
template <AnyJet J>
J constant_power(const J& a, const typename J::Number& exponent) {
    using T = typename J::Number;
    const auto term = [&](const T& factor, double lower) {
        return is_zero(factor) ? T(0.0) : factor * pow(a.value, exponent - lower);
    };
    const T factor = exponent * (exponent - 1.0);
    const J result =
        compose(a, pow(a.value, exponent), term(exponent, 1), [&] { return term(factor, 2); });
    const bool is_whole_power = is_zero(exponent - floor(exponent));
    return with_kink(result, !is_whole_power && may_be(a.value, 0));
}

template <AnyJet J>
J pow(const J& a, const J& b) {
    using T = typename J::Number;
    if (b.is_constant()) return with_kink(constant_power(a, b.value), !b.smooth);
    const T value = pow(a.value, b.value), lower = pow(a.value, b.value - 1.0);
    const T logarithm = log(a.value);
    return compose(
        std::array{&a, &b}, value, std::array<T, 2>{b.value * lower, value * logarithm}, [&] {
            return std::array<T, 3>{b.value * (b.value - 1.0) * pow(a.value, b.value - 2.0),
                                    lower * (1.0 + b.value * logarithm), value * square(logarithm)};
        });
}

template <AnyJet J>
J sqrt(const J& a) {
    const auto root = sqrt(a.value), first = 0.5 / root;
    return compose(a, root, first, [&] { return -0.5 * (first / a.value); });
}

template <AnyJet J>
J cbrt(const J& a) {
    const auto root = cbrt(a.value), first = 1.0 / (3.0 * square(root));
    return compose(a, root, first, [&] { return -2.0 * (first / (3.0 * a.value)); });
}

/// a over a length, and 0 where the length is: it has no second derivatives where it stays 0.
template <class T>
T over_length(const T& a, const T& length) {
    return is_zero(length) ? T(0.0) : a / length;
}

template <AnyJet J>
J hypot(const J& a, const J& b) {
    using T = typename J::Number;
    const T f = hypot(a.value, b.value);
    const T by_a = ratio(a.value, f), by_b = ratio(b.value, f);
    const J result = compose(std::array{&a, &b}, f, std::array<T, 2>{by_a, by_b}, [&] {
        return std::array<T, 3>{over_length(square(by_b), f), neg(over_length(by_a * by_b, f)),
                                over_length(square(by_a), f)};
    });
    return with_kink(result, !result.is_constant() && may_be(f, 0));
}

template <AnyJet J>
J hypot3(const J& a, const J& b, const J& c) {
    using T = typename J::Number;
    const T f = hypot3(a.value, b.value, c.value);
    const T by_a = ratio(a.value, f), by_b = ratio(b.value, f), by_c = ratio(c.value, f);
    const auto result = compose(std::array{&a, &b, &c}, f, std::array<T, 3>{by_a, by_b, by_c}, [&] {
        const T aa = square(by_a), bb = square(by_b), cc = square(by_c);
        const auto mixed = [&](const T& p, const T& q) { return neg(over_length(p * q, f)); };
        return std::array<T, 6>{over_length(bb + cc, f), mixed(by_a, by_b),
                                mixed(by_a, by_c),       over_length(aa + cc, f),
                                mixed(by_b, by_c),       over_length(aa + bb, f)};
    });
    return with_kink(result, !result.is_constant() && may_be(f, 0));
}

// Trigonometric, hyperbolic and exponential functions.

template <AnyJet J>
J sin(const J& a) {
    const auto value = sin(a.value);
    return compose(a, value, cos(a.value), [&] { return neg(value); });
}

template <AnyJet J>
J cos(const J& a) {
    const auto value = cos(a.value);
    return compose(a, value, neg(sin(a.value)), [&] { return neg(value); });
}

template <AnyJet J>
J tan(const J& a) {
    const auto value = tan(a.value), first = 1.0 + square(value);
    return compose(a, value, first, [&] { return 2.0 * value * first; });
}

/// 1 / sqrt(1 - a^2), the derivative of the inverse sine.
template <class T>
T inverse_sine_slope(const T& a) {
    return 1.0 / sqrt(1.0 - square(a));
}

template <AnyJet J>
J asin(const J& a) {
    const auto first = inverse_sine_slope(a.value);
    return compose(a, asin(a.value), first, [&] { return a.value * (square(first) * first); });
}

template <AnyJet J>
J acos(const J& a) {
    const auto first = inverse_sine_slope(a.value);
    return compose(a, acos(a.value), neg(first),
                   [&] { return neg(a.value * (square(first) * first)); });
}

template <AnyJet J>
J atan(const J& a) {
    const auto first = 1.0 / (1.0 + square(a.value));
    return compose(a, atan(a.value), first, [&] { return -2.0 * a.value * square(first); });
}

template <AnyJet J>
J atan2(const J& a, const J& b) {
    using T = typename J::Number;
    const T aa = square(a.value), bb = square(b.value), d = aa + bb;
    const T by_a = b.value / d, by_b = neg(a.value / d);
    const J result =
        compose(std::array{&a, &b}, atan2(a.value, b.value), std::array<T, 2>{by_a, by_b}, [&] {
            const T mixed = 2.0 * by_a * by_b;
            return std::array<T, 3>{mixed, (aa - bb) / square(d), neg(mixed)};
        });
    const bool on_cut = may_be(a.value, 0) && !is_zero(min(b.value, T(0.0)));
    return with_kink(result, !a.is_constant() && on_cut);
}

template <AnyJet J>
J sinh(const J& a) {
    const auto value = sinh(a.value);
    return compose(a, value, cosh(a.value), [&] { return value; });
}

template <AnyJet J>
J cosh(const J& a) {
    const auto value = cosh(a.value);
    return compose(a, value, sinh(a.value), [&] { return value; });
}

template <AnyJet J>
J tanh(const J& a) {
    const auto value = tanh(a.value), first = 1.0 - square(value);
    return compose(a, value, first, [&] { return -2.0 * value * first; });
}

template <AnyJet J>
J exp(const J& a) {
    const auto value = exp(a.value);
    return compose(a, value, value, [&] { return value; });
}

template <AnyJet J>
J log(const J& a) {
    const auto first = 1.0 / a.value;
    return compose(a, log(a.value), first, [&] { return neg(square(first)); });
}

// Pieces: straight or constant, with kinks and jumps.

/// A function that is constant between its jumps.
template <AnyJet J>
J staircase(const J& a, const typename J::Number& value, bool jumps) {
    J result(value);
    result.smooth = a.smooth && is_regular(value) && (a.is_constant() || !jumps);
    return result;
}

template <AnyJet J>
J sign(const J& a) {
    return staircase(a, sign(a.value), may_be(a.value, 0));
}
/// At a whole number both steps meet, whose values differ.
template <AnyJet J>
J floor(const J& a) {
    return staircase(a, floor(a.value), !is_zero(ceil(a.value) - floor(a.value) - 1.0));
}
template <AnyJet J>
J ceil(const J& a) {
    return staircase(a, ceil(a.value), !is_zero(ceil(a.value) - floor(a.value) - 1.0));
}

template <AnyJet J>
J abs(const J& a) {
    const auto side = sign(a.value);
    return with_kink(compose_linear(a, abs(a.value), [&](const auto& d) { return side * d; }),
                     !a.is_constant() && may_be(a.value, 0));
}

inline bool is_less(double a, double b) { return a < b; }
inline bool is_less(const Interval& a, const Interval& b) { return a.hi < b.lo; }

/// The derivatives of (a < b ? c : d), whose value it is.
template <AnyJet J>
J choice(const J& a, const J& b, const J& c, const J& d, const typename J::Number& value) {
    J result(value);
    for (int i = 0; i < J::size; ++i) {
        if (!c.has_slope(i) && !d.has_slope(i)) continue;
        result.set_slope(i, select_less(a.value, b.value, c.slope(i), d.slope(i)));
    }
    for (int place = 0; place < static_cast<int>(c.hessian.size()); ++place) {
        if (!c.has_bend(place) && !d.has_bend(place)) continue;
        result.set_bend(place, select_less(a.value, b.value, c.bend(place), d.bend(place)));
    }
    const bool fixed = a.is_constant() && b.is_constant() && is_zero(a.value - b.value);
    const bool less = is_less(a.value, b.value), more = fixed || is_less(b.value, a.value);
    // At a point a jump beside it may decide otherwise; over a box all values are compared.
    const bool decides = std::is_same_v<typename J::Number, Interval> || (a.smooth && b.smooth);
    result.smooth = is_regular(value) && decides && ((less && c.smooth) || (more && d.smooth));
    return result;
}

template <AnyJet J>
J min(const J& a, const J& b) {
    return choice(b, a, b, a, min(a.value, b.value));
}
template <AnyJet J>
J max(const J& a, const J& b) {
    return choice(a, b, b, a, max(a.value, b.value));
}
template <AnyJet J>
J select_less(const J& a, const J& b, const J& c, const J& d) {
    return choice(a, b, c, d, select_less(a.value, b.value, c.value, d.value));
}

}  // namespace numeric
