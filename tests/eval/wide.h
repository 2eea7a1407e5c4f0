// SPDX-License-Identifier: MIT
// Numbers of more bits than double, and all operators on them: the reference for double, intervals
// and jets.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "graph/graph.h"
#include "numeric/jet_operators.h"

extern "C" {
#include <quadmath.h>
}

namespace eval {

// Of both kinds the functions of the C library under one name.
#define ZEROSET_WIDE_1(name)                                               \
    inline long double wide_##name(long double a) { return std::name(a); } \
    inline __float128 wide_##name(__float128 a) { return name##q(a); }
#define ZEROSET_WIDE_2(name)                                                                 \
    inline long double wide_##name(long double a, long double b) { return std::name(a, b); } \
    inline __float128 wide_##name(__float128 a, __float128 b) { return name##q(a, b); }
ZEROSET_WIDE_1(sqrt)
ZEROSET_WIDE_1(cbrt)
ZEROSET_WIDE_1(sin)
ZEROSET_WIDE_1(cos)
ZEROSET_WIDE_1(tan)
ZEROSET_WIDE_1(asin)
ZEROSET_WIDE_1(acos)
ZEROSET_WIDE_1(atan)
ZEROSET_WIDE_1(sinh)
ZEROSET_WIDE_1(cosh)
ZEROSET_WIDE_1(tanh)
ZEROSET_WIDE_1(exp)
ZEROSET_WIDE_1(log)
ZEROSET_WIDE_1(floor)
ZEROSET_WIDE_1(ceil)
ZEROSET_WIDE_2(pow)
ZEROSET_WIDE_2(hypot)
ZEROSET_WIDE_2(atan2)
#undef ZEROSET_WIDE_1
#undef ZEROSET_WIDE_2

/// A number with the operators of graph/operators.def; R is long double (64 bits on x86) or
/// __float128 (113 bits).
template <class R>
struct Wide {
    R number = 0;

    Wide() = default;
    Wide(double value) : number(value) {}
    static Wide of(R value) {
        Wide result;
        result.number = value;
        return result;
    }
    static Wide nan() { return numeric::not_a_number; }
    explicit operator double() const { return static_cast<double>(number); }
    bool is_nan() const { return number != number; }
    bool is_finite() const { return number - number == 0; }

    friend Wide operator-(const Wide& a) { return of(-a.number); }
    friend Wide operator+(const Wide& a, const Wide& b) { return of(a.number + b.number); }
    friend Wide operator-(const Wide& a, const Wide& b) { return of(a.number - b.number); }
    friend Wide operator*(const Wide& a, const Wide& b) { return of(a.number * b.number); }
    friend Wide operator/(const Wide& a, const Wide& b) { return of(a.number / b.number); }

    friend Wide neg(const Wide& a) { return -a; }
    friend Wide add(const Wide& a, const Wide& b) { return a + b; }
    friend Wide sub(const Wide& a, const Wide& b) { return a - b; }
    friend Wide mul(const Wide& a, const Wide& b) { return a * b; }
    friend Wide div(const Wide& a, const Wide& b) { return a / b; }
    friend Wide square(const Wide& a) { return a * a; }
    friend Wide pow(const Wide& a, const Wide& b) {
        const bool is_whole = b.is_finite() && wide_floor(b.number) == b.number;
        if (a.is_nan() || b.is_nan() || (a.number < 0 && !is_whole)) return nan();
        return of(wide_pow(a.number, b.number));
    }
    friend Wide sqrt(const Wide& a) { return of(wide_sqrt(a.number)); }
    friend Wide cbrt(const Wide& a) { return of(wide_cbrt(a.number)); }
    friend Wide hypot(const Wide& a, const Wide& b) {
        return a.is_nan() || b.is_nan() ? nan() : of(wide_hypot(a.number, b.number));
    }
    friend Wide hypot3(const Wide& a, const Wide& b, const Wide& c) {
        return hypot(hypot(a, b), c);
    }
    friend Wide sin(const Wide& a) { return of(wide_sin(a.number)); }
    friend Wide cos(const Wide& a) { return of(wide_cos(a.number)); }
    friend Wide tan(const Wide& a) { return of(wide_tan(a.number)); }
    friend Wide asin(const Wide& a) { return of(wide_asin(a.number)); }
    friend Wide acos(const Wide& a) { return of(wide_acos(a.number)); }
    friend Wide atan(const Wide& a) { return of(wide_atan(a.number)); }
    friend Wide atan2(const Wide& a, const Wide& b) {
        return of(wide_atan2(a.number + 0, b.number + 0));
    }
    friend Wide sinh(const Wide& a) { return of(wide_sinh(a.number)); }
    friend Wide cosh(const Wide& a) { return of(wide_cosh(a.number)); }
    friend Wide tanh(const Wide& a) { return of(wide_tanh(a.number)); }
    friend Wide exp(const Wide& a) { return of(wide_exp(a.number)); }
    friend Wide log(const Wide& a) { return a.number > 0 ? of(wide_log(a.number)) : nan(); }
    friend Wide abs(const Wide& a) { return a.number < 0 ? -a : a + 0.0; }
    friend Wide sign(const Wide& a) {
        return a.is_nan() ? a : Wide((a.number > 0) - (a.number < 0));
    }
    friend Wide floor(const Wide& a) { return of(wide_floor(a.number)); }
    friend Wide ceil(const Wide& a) { return of(wide_ceil(a.number)); }
    friend Wide min(const Wide& a, const Wide& b) {
        if (a.is_nan() || b.is_nan()) return nan();
        return b.number < a.number ? b : a;
    }
    friend Wide max(const Wide& a, const Wide& b) { return -min(-a, -b); }
    friend Wide ratio(const Wide& a, const Wide& b) {
        if (a.number == 0 && b.number == 0) return 0.0;
        return max(-1.0, min(1.0, a / b));
    }
    friend Wide select_less(const Wide& a, const Wide& b, const Wide& c, const Wide& d) {
        if (a.is_nan() || b.is_nan()) return nan();
        return a.number < b.number ? c : d;
    }

    // What jets ask of a number.
    friend bool is_regular(const Wide& a) { return a.is_finite(); }
    friend bool may_be(const Wide& a, double value) { return a.number == value; }
    friend bool is_zero(const Wide& a) { return a.number == 0; }
    friend bool is_less(const Wide& a, const Wide& b) { return a.number < b.number; }
};

using Quad = Wide<__float128>;
using Extended = Wide<long double>;

/// The operator on numbers of any type that has all of them, found by their type.
template <class T>
T apply_by_type(graph::Op op, const std::vector<T>& v) {
#define ZEROSET_CALL_1(name) name(v[0])
#define ZEROSET_CALL_2(name) name(v[0], v[1])
#define ZEROSET_CALL_3(name) name(v[0], v[1], v[2])
#define ZEROSET_CALL_4(name) name(v[0], v[1], v[2], v[3])
    switch (op) {
        case graph::Op::constant:
        case graph::Op::variable:
        case graph::Op::parameter:
            break;
#define OPERATOR(name, arity, glsl, file) \
    case graph::Op::name:                 \
        return ZEROSET_CALL_##arity(name);
#include "graph/operators.def"
    }
#undef ZEROSET_CALL_1
#undef ZEROSET_CALL_2
#undef ZEROSET_CALL_3
#undef ZEROSET_CALL_4
    return v.front();
}

/// The values of all that the root needs, by the definition of a graph; the last one is its own.
template <class T>
std::vector<T> values_by_type(const graph::Graph& graph, graph::NodeId root,
                              std::span<const T> variables, std::span<const T> parameters) {
    std::vector<T> values(index(root) + 1, T(0.0));
    for (const graph::NodeId id : reachable(graph, std::array{root})) {
        const graph::Node& node = graph[id];
        std::vector<T> arguments;
        for (const graph::NodeId argument : node.args()) {
            arguments.push_back(values[index(argument)]);
        }
        T& value = values[index(id)];
        if (node.op == graph::Op::constant) value = T(node.value);
        if (node.op == graph::Op::variable) value = variables[node.symbol];
        if (node.op == graph::Op::parameter) value = parameters[node.symbol];
        if (!arguments.empty()) value = apply_by_type(node.op, arguments);
    }
    return values;
}

}  // namespace eval
