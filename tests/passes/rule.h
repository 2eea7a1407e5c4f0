// SPDX-License-Identifier: MIT
// One rule on one expression, and what comes of it as text.
#pragma once

#include <algorithm>
#include <array>
#include <string>

#include "graph/build.h"
#include "graph/print.h"
#include "passes/rewrite.h"

namespace passes {

using graph::Expr;
using graph::Op;

/// The variables x, y, z and the parameter t, in this order, of a graph of its own.
struct Leaves {
    graph::Graph graph;
    Expr x{graph, graph.variable(graph::variable_x)};
    Expr y{graph, graph.variable(graph::variable_y)};
    Expr z{graph, graph.variable(graph::variable_z)};
    Expr t{graph, graph.parameter(graph::parameter_t)};

    Leaves() = default;
    Leaves(const Leaves&) = delete;
    Leaves& operator=(const Leaves&) = delete;

    Expr number(double value) { return {graph, value}; }
};

/// The expression in one line, operators before their arguments: `add(x, mul(y, 2))`.
inline std::string in_one_line(const graph::Graph& graph, graph::NodeId id) {
    const graph::Node& node = graph[id];
    if (node.op == Op::constant) return graph::shortest(node.value);
    if (node.op == Op::variable) return graph.name(static_cast<graph::VariableId>(node.symbol));
    if (node.op == Op::parameter) return graph.name(static_cast<graph::ParameterId>(node.symbol));
    std::string text(graph::facts(node.op).name);
    const char* before = "(";
    for (const graph::NodeId argument : node.args()) {
        text += before + in_one_line(graph, argument);
        before = ", ";
    }
    return text + ')';
}

/// What the rule, applied everywhere, makes of the expression.
inline std::string rewritten(Rule rule, Expr expression) {
    graph::Graph& graph = *expression.graph;
    return in_one_line(graph, rewrite(graph, std::array{expression.id}, rule)[0]);
}

/// What the transformation makes of the expression.
inline std::string transformed(Transformation transformation, Expr expression) {
    graph::Graph& graph = *expression.graph;
    return in_one_line(graph, transformation(graph, std::array{expression.id})[0]);
}

}  // namespace passes
