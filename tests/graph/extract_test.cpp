// SPDX-License-Identifier: MIT
// A part of a graph means the same alone.
#include "graph/extract.h"

#include <gtest/gtest.h>

#include "graph/print.h"

namespace {

using graph::Graph;
using graph::NodeId;
using graph::Op;

TEST(Extract, holds_what_the_roots_need_and_no_more) {
    Graph g;
    const NodeId x = g.variable(graph::variable_x), y = g.variable(graph::variable_y);
    const NodeId sum = g.apply(Op::add, x, y);
    g.apply(Op::sin, sum);
    const NodeId product = g.apply(Op::mul, sum, g.constant(3));
    const std::array roots{product, x};
    const graph::Extract part = extract(g, roots);
    EXPECT_EQ(part.graph.size(), 5U);
    EXPECT_EQ(print(part.graph, part.roots), print(g, roots));
}

TEST(Extract, keeps_the_numbers_of_variables_and_parameters) {
    Graph g;
    g.new_variable("a");
    const NodeId b = g.variable(g.new_variable("b"));
    const NodeId p = g.parameter(g.new_parameter("p"));
    const graph::Extract part = extract(g, std::array{g.apply(Op::mul, b, p)});
    const graph::Node& product = part.graph[part.roots[0]];
    EXPECT_EQ(part.graph[product.arguments[0]].symbol, g[b].symbol);
    EXPECT_EQ(part.graph[product.arguments[1]].symbol, g[p].symbol);
    EXPECT_EQ(part.graph.name(static_cast<graph::VariableId>(4)), "b");
    EXPECT_EQ(part.graph.name(static_cast<graph::ParameterId>(1)), "p");
}

}  // namespace
