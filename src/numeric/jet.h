// SPDX-License-Identifier: MIT
// A number together with its derivatives, and the chain rule: forward automatic differentiation
// (Griewank & Walther, "Evaluating Derivatives", 2nd ed., chapters 3 and 13). The operators on jets
// are in numeric/jet_operators.h.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>

#include "numeric/interval.h"

namespace numeric {

/// The place of the pair (i, j), i <= j, in the upper triangle of a symmetric matrix with `size`
/// rows, row after row: for three rows xx, xy, xz, yy, yz, zz.
constexpr int triangle_place(int i, int j, int size) { return i * size - i * (i - 1) / 2 + j - i; }

/// A value, its gradient by n variables (n <= 3) and, of order 2, its Hessian. T is double, or
/// Interval: then all of them are enclosures over the same box at once.
///
/// Which derivatives are zero whatever the place, because the value does not depend on a variable
/// or only linearly, is known: such a derivative stays 0 also where the chain rule would multiply
/// it by an infinity. The others are what the chain rule gives: infinite or NaN where they do not
/// exist (over intervals: unbounded, `partial` or `jumps`), and those of one side at a kink and 0
/// where a length is 0, as passes/differentiate.h says. `smooth` tells.
template <class T, int n, int order>
struct Jet {
    static_assert(n >= 1 && n <= 3 && (order == 1 || order == 2));
    static constexpr int size = n;
    static constexpr bool has_hessian = order == 2;
    using Number = T;

    T value{};
    std::array<T, n> gradient{};
    std::array<T, has_hessian ? n*(n + 1) / 2 : 0> hessian{};  ///< by triangle_place
    std::uint8_t gradient_support = 0;  ///< bit i: gradient[i] may be other than 0
    std::uint8_t hessian_support = 0;   ///< bit i: hessian[i] may be other than 0
    /// True if the derivatives up to the order exist, are continuous and follow from the chain
    /// rule: over intervals a proof for the whole box, for double judged at the very point (a kink
    /// beside it, or one that is rounded away, is not seen). False at kinks, jumps, poles, edges of
    /// domains and where there is no value.
    bool smooth = true;

    Jet() = default;
    /// A number that depends on no variable.
    explicit Jet(const T& constant) : value(constant) {}
    /// The i-th variable.
    static Jet variable(const T& at, int i) {
        Jet jet(at);
        jet.gradient[static_cast<std::size_t>(i)] = T(1.0);
        jet.gradient_support = static_cast<std::uint8_t>(1U << i);
        return jet;
    }
    /// A coordinate along a ray, in one variable: `at` where the parameter is 0, changing by
    /// `slope`.
    static Jet along(const T& at, const T& slope) requires(n == 1) {
        Jet jet = variable(at, 0);
        jet.gradient[0] = slope;
        return jet;
    }

    bool is_constant() const { return gradient_support == 0; }
    bool has_slope(int i) const { return (gradient_support >> i & 1U) != 0; }
    bool has_bend(int place) const { return (hessian_support >> place & 1U) != 0; }
    const T& slope(int i) const { return gradient[static_cast<std::size_t>(i)]; }
    /// The second derivative at triangle_place.
    const T& bend(int place) const { return hessian[static_cast<std::size_t>(place)]; }

    void set_slope(int i, const T& slope) {
        gradient[static_cast<std::size_t>(i)] = slope;
        gradient_support = static_cast<std::uint8_t>(gradient_support | 1U << i);
    }
    void set_bend(int place, const T& bend) {
        hessian[static_cast<std::size_t>(place)] = bend;
        hessian_support = static_cast<std::uint8_t>(hessian_support | 1U << place);
    }
};

/// Value and gradient: a dual number.
template <class T, int n = 3>
using Dual = Jet<T, n, 1>;
/// Value, gradient and Hessian: a second-order number. With one variable: f, f' and f'' along a
/// ray.
template <class T, int n = 3>
using SecondOrder = Jet<T, n, 2>;

template <class J>
concept AnyJet = requires {
    typename J::Number;
    J::has_hessian;
}
&&requires(J j) { j.gradient_support; };

/// Adds to a sum that may be empty yet.
template <class T>
struct Sum {
    T total{};
    bool any = false;

    void add(const T& term) {
        total = any ? total + term : term;
        any = true;
    }
};

/// True if the number proves that a function is defined and continuous where it comes from.
inline bool is_regular(double a) { return std::isfinite(a); }
inline bool is_regular(const Interval& a) { return !a.is_empty() && !a.partial && !a.jumps; }

/// Calls visit(i, j, place) for each pair i <= j < n.
template <int n, class Visit>
constexpr void for_each_pair(Visit visit) {
    for (int i = 0, place = 0; i < n; ++i) {
        for (int j = i; j < n; ++j, ++place) visit(i, j, place);
    }
}

/// What a function's second derivative by its arguments g and h is multiplied by: g_i h_j + g_j
/// h_i, or, if both are the same argument, g_i g_j.
template <AnyJet J>
Sum<typename J::Number> product_of_slopes(const J& g, const J& h, bool same, int i, int j) {
    Sum<typename J::Number> sum;
    const bool direct = g.has_slope(i) && h.has_slope(j);
    if (same) {
        if (direct) sum.add(i == j ? square(g.slope(i)) : g.slope(i) * g.slope(j));
        return sum;
    }
    if (i == j) {
        if (!direct) return sum;
        const auto half = g.slope(i) * h.slope(i);
        sum.add(half + half);
        return sum;
    }
    if (direct) sum.add(g.slope(i) * h.slope(j));
    if (g.has_slope(j) && h.has_slope(i)) sum.add(g.slope(j) * h.slope(i));
    return sum;
}

/// The chain rule: the jet of a function of k numbers, from its value, its first derivatives, and
/// its second ones (packed by triangle_place; `second` is called if they are needed).
template <AnyJet J, std::size_t k, class Second>
J compose(const std::array<const J*, k>& arguments, const typename J::Number& value,
          const std::array<typename J::Number, k>& first, Second second) {
    constexpr int n = J::size, arity = static_cast<int>(k);
    J result(value);
    result.smooth = is_regular(value);
    for (std::size_t p = 0; p < k; ++p) {
        result.smooth = result.smooth && arguments[p]->smooth &&
                        (arguments[p]->is_constant() || is_regular(first[p]));
    }
    for (int i = 0; i < n; ++i) {
        Sum<typename J::Number> sum;
        for (std::size_t p = 0; p < k; ++p) {
            if (arguments[p]->has_slope(i)) sum.add(first[p] * arguments[p]->slope(i));
        }
        if (sum.any) result.set_slope(i, sum.total);
    }
    if constexpr (J::has_hessian) {
        if (result.is_constant()) return result;
        const auto bends = second();
        for_each_pair<arity>([&](int p, int q, int pq) {
            if (arguments[static_cast<std::size_t>(p)]->is_constant()) return;
            if (arguments[static_cast<std::size_t>(q)]->is_constant()) return;
            result.smooth = result.smooth && is_regular(bends[static_cast<std::size_t>(pq)]);
        });
        for_each_pair<n>([&](int i, int j, int place) {
            Sum<typename J::Number> sum;
            for (std::size_t p = 0; p < k; ++p) {
                if (arguments[p]->has_bend(place)) sum.add(first[p] * arguments[p]->bend(place));
            }
            for_each_pair<arity>([&](int p, int q, int pq) {
                const auto slopes =
                    product_of_slopes(*arguments[static_cast<std::size_t>(p)],
                                      *arguments[static_cast<std::size_t>(q)], p == q, i, j);
                if (slopes.any) sum.add(bends[static_cast<std::size_t>(pq)] * slopes.total);
            });
            if (sum.any) result.set_bend(place, sum.total);
        });
    }
    return result;
}

/// The same for a function of one number.
template <AnyJet J, class Second>
J compose(const J& a, const typename J::Number& value, const typename J::Number& first,
          Second second) {
    return compose(std::array{&a}, value, std::array{first}, [&] { return std::array{second()}; });
}

/// The jet of a linear function: each derivative of the arguments goes through `each`.
template <AnyJet J, class Each>
J compose_linear(const J& a, const typename J::Number& value, Each each) {
    J result(value);
    result.smooth = a.smooth && is_regular(value);
    for (int i = 0; i < J::size; ++i) {
        if (a.has_slope(i)) result.set_slope(i, each(a.slope(i)));
    }
    if constexpr (J::has_hessian) {
        for (int place = 0; place < static_cast<int>(a.hessian.size()); ++place) {
            if (a.has_bend(place)) result.set_bend(place, each(a.bend(place)));
        }
    }
    return result;
}

}  // namespace numeric
