// SPDX-License-Identifier: MIT
#include "formula/functions.h"

#include <algorithm>

#include "graph/build.h"

namespace formula {
namespace {

using graph::Expr;
using graph::Graph;
using graph::NodeId;
using graph::Op;
using Arguments = std::span<const NodeId>;

template <Op op>
NodeId plain(Graph& graph, Arguments a) {
    return graph.apply(op, a);
}

/// From the left, two at a time.
template <Op op>
NodeId fold(Graph& graph, Arguments a) {
    NodeId value = a[0];
    for (const NodeId next : a.subspan(1)) value = graph.apply(op, value, next);
    return value;
}

NodeId hypot(Graph& graph, Arguments a) {
    return graph.apply(a.size() == 3 ? Op::hypot3 : Op::hypot, a);
}

NodeId mod(Graph& graph, Arguments args) {
    const Expr a(graph, args[0]), b(graph, args[1]);
    return (a - b * floor(a / b)).id;
}

Expr clamp(Expr value, Expr low, Expr high) { return min(max(value, low), high); }

NodeId clamp(Graph& graph, Arguments a) {
    return clamp(Expr(graph, a[0]), Expr(graph, a[1]), Expr(graph, a[2])).id;
}

NodeId mix(Graph& graph, Arguments args) {
    const Expr a(graph, args[0]), b(graph, args[1]), t(graph, args[2]);
    return (a + (b - a) * t).id;
}

NodeId step(Graph& graph, Arguments a) {
    const Expr edge(graph, a[0]), value(graph, a[1]);
    return select_less(value, edge, Expr(graph, 0.0), Expr(graph, 1.0)).id;
}

NodeId smoothstep(Graph& graph, Arguments args) {
    const Expr low(graph, args[0]), high(graph, args[1]), value(graph, args[2]);
    const Expr t = clamp((value - low) / (high - low), Expr(graph, 0.0), Expr(graph, 1.0));
    return (t * t * (3.0 - 2.0 * t)).id;
}

constexpr Function table[] = {
    {"abs", "abs(a)", 1, 1, OnVectors::all, plain<Op::abs>},
    {"acos", "acos(a)", 1, 1, OnVectors::plain, plain<Op::acos>},
    {"asin", "asin(a)", 1, 1, OnVectors::plain, plain<Op::asin>},
    {"atan", "atan(a)", 1, 1, OnVectors::plain, plain<Op::atan>},
    {"atan2", "atan2(y, x)", 2, 2, OnVectors::plain, plain<Op::atan2>},
    {"cbrt", "cbrt(a)", 1, 1, OnVectors::plain, plain<Op::cbrt>},
    {"ceil", "ceil(a)", 1, 1, OnVectors::all, plain<Op::ceil>},
    {"clamp", "clamp(a, low, high)", 3, 3, OnVectors::all, clamp},
    {"cos", "cos(a)", 1, 1, OnVectors::plain, plain<Op::cos>},
    {"cosh", "cosh(a)", 1, 1, OnVectors::plain, plain<Op::cosh>},
    {"exp", "exp(a)", 1, 1, OnVectors::plain, plain<Op::exp>},
    {"floor", "floor(a)", 1, 1, OnVectors::all, plain<Op::floor>},
    {"hypot", "hypot(a, b) or hypot(a, b, c)", 2, 3, OnVectors::none, hypot},
    {"log", "log(a)", 1, 1, OnVectors::plain, plain<Op::log>},
    {"max", "max(a, b, ...)", 2, any_number, OnVectors::all, fold<Op::max>},
    {"min", "min(a, b, ...)", 2, any_number, OnVectors::all, fold<Op::min>},
    {"mix", "mix(a, b, t)", 3, 3, OnVectors::all, mix},
    {"mod", "mod(a, b)", 2, 2, OnVectors::all, mod},
    {"pow", "pow(a, b)", 2, 2, OnVectors::none, plain<Op::pow>},
    {"sign", "sign(a)", 1, 1, OnVectors::all, plain<Op::sign>},
    {"sin", "sin(a)", 1, 1, OnVectors::plain, plain<Op::sin>},
    {"sinh", "sinh(a)", 1, 1, OnVectors::plain, plain<Op::sinh>},
    {"smoothstep", "smoothstep(low, high, a)", 3, 3, OnVectors::all, smoothstep},
    {"sqrt", "sqrt(a)", 1, 1, OnVectors::plain, plain<Op::sqrt>},
    {"step", "step(edge, a)", 2, 2, OnVectors::all, step},
    {"tan", "tan(a)", 1, 1, OnVectors::plain, plain<Op::tan>},
    {"tanh", "tanh(a)", 1, 1, OnVectors::plain, plain<Op::tanh>},
};

}  // namespace

std::span<const Function> functions() { return table; }

const Function* find_function(std::string_view name) {
    const auto* const found = std::ranges::find(table, name, &Function::name);
    return found == std::end(table) ? nullptr : found;
}

NodeId radius(Graph& graph) {
    return graph.apply(Op::hypot3, graph.variable(graph::variable_x),
                       graph.variable(graph::variable_y), graph.variable(graph::variable_z));
}

}  // namespace formula
