// SPDX-License-Identifier: MIT
// Numbers of 113 bits and all operators on them: the reference for double, intervals and jets.
#pragma once

#include <span>
#include <vector>

#include "graph/graph.h"
#include "numeric/jet_operators.h"

// The compiler's own header for quadruple precision is C and is not clean under -Wpedantic.
extern "C" {
#include <quadmath.h>
}

namespace eval {

struct Quad {
    __float128 q = 0;

    Quad() = default;
    Quad(double number) : q(number) {}
    static Quad of(__float128 number) {
        Quad result;
        result.q = number;
        return result;
    }
    explicit operator double() const { return static_cast<double>(q); }
};

inline Quad quad_nan() { return Quad(numeric::not_a_number); }
inline bool is_nan(const Quad& a) { return isnanq(a.q) != 0; }

inline Quad operator-(const Quad& a) { return Quad::of(-a.q); }
inline Quad operator+(const Quad& a, const Quad& b) { return Quad::of(a.q + b.q); }
inline Quad operator-(const Quad& a, const Quad& b) { return Quad::of(a.q - b.q); }
inline Quad operator*(const Quad& a, const Quad& b) { return Quad::of(a.q * b.q); }
inline Quad operator/(const Quad& a, const Quad& b) { return Quad::of(a.q / b.q); }

inline Quad neg(const Quad& a) { return -a; }
inline Quad add(const Quad& a, const Quad& b) { return a + b; }
inline Quad sub(const Quad& a, const Quad& b) { return a - b; }
inline Quad mul(const Quad& a, const Quad& b) { return a * b; }
inline Quad div(const Quad& a, const Quad& b) { return a / b; }
inline Quad square(const Quad& a) { return a * a; }
inline Quad pow(const Quad& a, const Quad& b) {
    if (is_nan(a) || is_nan(b) || (a.q < 0 && (!finiteq(b.q) || floorq(b.q) != b.q))) {
        return quad_nan();
    }
    return Quad::of(powq(a.q, b.q));
}
inline Quad sqrt(const Quad& a) { return Quad::of(sqrtq(a.q)); }
inline Quad cbrt(const Quad& a) { return Quad::of(cbrtq(a.q)); }
inline Quad hypot(const Quad& a, const Quad& b) {
    return is_nan(a) || is_nan(b) ? quad_nan() : Quad::of(hypotq(a.q, b.q));
}
inline Quad hypot3(const Quad& a, const Quad& b, const Quad& c) { return hypot(hypot(a, b), c); }
inline Quad sin(const Quad& a) { return Quad::of(sinq(a.q)); }
inline Quad cos(const Quad& a) { return Quad::of(cosq(a.q)); }
inline Quad tan(const Quad& a) { return Quad::of(tanq(a.q)); }
inline Quad asin(const Quad& a) { return Quad::of(asinq(a.q)); }
inline Quad acos(const Quad& a) { return Quad::of(acosq(a.q)); }
inline Quad atan(const Quad& a) { return Quad::of(atanq(a.q)); }
inline Quad atan2(const Quad& a, const Quad& b) { return Quad::of(atan2q(a.q + 0, b.q + 0)); }
inline Quad sinh(const Quad& a) { return Quad::of(sinhq(a.q)); }
inline Quad cosh(const Quad& a) { return Quad::of(coshq(a.q)); }
inline Quad tanh(const Quad& a) { return Quad::of(tanhq(a.q)); }
inline Quad exp(const Quad& a) { return Quad::of(expq(a.q)); }
inline Quad log(const Quad& a) { return a.q > 0 ? Quad::of(logq(a.q)) : quad_nan(); }
inline Quad abs(const Quad& a) { return Quad::of(fabsq(a.q)); }
inline Quad sign(const Quad& a) { return is_nan(a) ? a : Quad((a.q > 0) - (a.q < 0)); }
inline Quad floor(const Quad& a) { return Quad::of(floorq(a.q)); }
inline Quad ceil(const Quad& a) { return Quad::of(ceilq(a.q)); }
inline Quad min(const Quad& a, const Quad& b) {
    if (is_nan(a) || is_nan(b)) return quad_nan();
    return b.q < a.q ? b : a;
}
inline Quad max(const Quad& a, const Quad& b) { return neg(min(neg(a), neg(b))); }
inline Quad ratio(const Quad& a, const Quad& b) {
    if (a.q == 0 && b.q == 0) return 0.0;
    return max(-1.0, min(1.0, a / b));
}
inline Quad select_less(const Quad& a, const Quad& b, const Quad& c, const Quad& d) {
    if (is_nan(a) || is_nan(b)) return quad_nan();
    return a.q < b.q ? c : d;
}

inline bool is_regular(const Quad& a) { return finiteq(a.q) != 0; }
inline bool may_be(const Quad& a, double number) { return a.q == number; }
inline bool is_zero(const Quad& a) { return a.q == 0; }
inline bool is_less(const Quad& a, const Quad& b) { return a.q < b.q; }

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
