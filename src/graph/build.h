// SPDX-License-Identifier: MIT
// Arithmetic on graph nodes in the notation of arithmetic, for code that builds expressions.
#pragma once

#include "graph/graph.h"

namespace graph {

/// A node together with its graph, so that `a * b + 1.0` builds nodes. Only for building: hold
/// NodeIds elsewhere. Nothing is simplified on the way.
struct Expr {
    Graph* graph = nullptr;
    NodeId id{};

    Expr(Graph& g, NodeId node) : graph(&g), id(node) {}
    Expr(Graph& g, double value) : graph(&g), id(g.constant(value)) {}
};

inline Expr apply(Op op, Expr a) { return {*a.graph, a.graph->apply(op, a.id)}; }
inline Expr apply(Op op, Expr a, Expr b) { return {*a.graph, a.graph->apply(op, a.id, b.id)}; }

inline Expr operator-(Expr a) { return apply(Op::neg, a); }
inline Expr operator+(Expr a, Expr b) { return apply(Op::add, a, b); }
inline Expr operator-(Expr a, Expr b) { return apply(Op::sub, a, b); }
inline Expr operator*(Expr a, Expr b) { return apply(Op::mul, a, b); }
inline Expr operator/(Expr a, Expr b) { return apply(Op::div, a, b); }
inline Expr operator+(Expr a, double b) { return a + Expr(*a.graph, b); }
inline Expr operator-(Expr a, double b) { return a - Expr(*a.graph, b); }
inline Expr operator*(Expr a, double b) { return a * Expr(*a.graph, b); }
inline Expr operator/(Expr a, double b) { return a / Expr(*a.graph, b); }
inline Expr operator+(double a, Expr b) { return Expr(*b.graph, a) + b; }
inline Expr operator-(double a, Expr b) { return Expr(*b.graph, a) - b; }
inline Expr operator*(double a, Expr b) { return Expr(*b.graph, a) * b; }
inline Expr operator/(double a, Expr b) { return Expr(*b.graph, a) / b; }

inline Expr min(Expr a, Expr b) { return apply(Op::min, a, b); }
inline Expr max(Expr a, Expr b) { return apply(Op::max, a, b); }
inline Expr min(Expr a, double b) { return min(a, Expr(*a.graph, b)); }
inline Expr max(Expr a, double b) { return max(a, Expr(*a.graph, b)); }
inline Expr pow(Expr a, Expr b) { return apply(Op::pow, a, b); }
inline Expr abs(Expr a) { return apply(Op::abs, a); }
inline Expr sqrt(Expr a) { return apply(Op::sqrt, a); }
inline Expr sin(Expr a) { return apply(Op::sin, a); }
inline Expr cos(Expr a) { return apply(Op::cos, a); }
inline Expr acos(Expr a) { return apply(Op::acos, a); }
inline Expr exp(Expr a) { return apply(Op::exp, a); }
inline Expr log(Expr a) { return apply(Op::log, a); }
inline Expr floor(Expr a) { return apply(Op::floor, a); }
inline Expr sign(Expr a) { return apply(Op::sign, a); }
inline Expr atan2(Expr y, Expr x) { return apply(Op::atan2, y, x); }
inline Expr hypot(Expr a, Expr b) { return apply(Op::hypot, a, b); }
inline Expr hypot(Expr a, Expr b, Expr c) {
    return {*a.graph, a.graph->apply(Op::hypot3, a.id, b.id, c.id)};
}
/// a / b where |a| <= b is known; 0 for 0 / 0.
inline Expr ratio(Expr a, Expr b) { return apply(Op::ratio, a, b); }
/// a < b ? c : d
inline Expr select_less(Expr a, Expr b, Expr c, Expr d) {
    return {*a.graph, a.graph->apply(Op::select_less, a.id, b.id, c.id, d.id)};
}

}  // namespace graph
