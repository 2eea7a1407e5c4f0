// SPDX-License-Identifier: MIT
// The arena of nodes: equal expressions are one node, and order and dependence follow from it.
#include "graph/graph.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace {

using graph::Graph;
using graph::NodeId;
using graph::Op;

TEST(Graph, gives_equal_expressions_one_node) {
    Graph g;
    const NodeId x = g.variable(graph::variable_x);
    const NodeId y = g.variable(graph::variable_y);
    const NodeId sum = g.apply(Op::add, x, g.constant(2));
    const std::size_t size = g.size();
    EXPECT_EQ(g.apply(Op::add, g.variable(graph::variable_x), g.constant(2)), sum);
    EXPECT_EQ(g.size(), size);
    EXPECT_NE(g.apply(Op::sub, x, g.constant(2)), sum);
    EXPECT_NE(g.apply(Op::add, y, g.constant(2)), sum);
    EXPECT_NE(x, y);
}

TEST(Graph, does_not_rewrite) {
    Graph g;
    const NodeId x = g.variable(graph::variable_x);
    const NodeId y = g.variable(graph::variable_y);
    EXPECT_NE(g.apply(Op::add, x, y), g.apply(Op::add, y, x));
    EXPECT_EQ(g[g.apply(Op::mul, x, g.constant(1))].op, Op::mul);
}

TEST(Graph, keeps_zero_and_minus_zero_apart) {
    Graph g;
    const NodeId zero = g.constant(0.0);
    const NodeId minus_zero = g.constant(-0.0);
    EXPECT_NE(zero, minus_zero);
    EXPECT_FALSE(std::signbit(g[zero].value));
    EXPECT_TRUE(std::signbit(g[minus_zero].value));
    // As values they are equal.
    EXPECT_TRUE(g.is_constant(minus_zero, 0.0));
}

TEST(Graph, gives_nan_one_node) {
    Graph g;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(g.constant(nan), g.constant(nan));
}

TEST(Graph, keeps_variables_and_parameters_of_one_number_apart) {
    Graph g;
    EXPECT_NE(g.variable(graph::variable_x), g.parameter(graph::parameter_t));
}

TEST(Graph, begins_with_the_point_and_the_time) {
    const Graph g;
    EXPECT_EQ(g.variable_count(), 3u);
    EXPECT_EQ(g.parameter_count(), 1u);
    EXPECT_EQ(g.name(graph::variable_x), "x");
    EXPECT_EQ(g.name(graph::variable_y), "y");
    EXPECT_EQ(g.name(graph::variable_z), "z");
    EXPECT_EQ(g.name(graph::parameter_t), "t");
}

TEST(Graph, gives_new_parameters_of_one_name_different_nodes) {
    Graph g;
    const auto a = g.new_parameter("a");
    const auto b = g.new_parameter("a");
    EXPECT_NE(g.parameter(a), g.parameter(b));
    EXPECT_EQ(g.name(b), "a");
}

TEST(Graph, knows_its_constants) {
    Graph g;
    const NodeId two = g.constant(2);
    EXPECT_TRUE(g.is_constant(two));
    EXPECT_TRUE(g.is_constant(two, 2));
    EXPECT_FALSE(g.is_constant(two, 3));
    EXPECT_FALSE(g.is_constant(g.variable(graph::variable_x)));
    EXPECT_FALSE(g.is_constant(g.variable(graph::variable_x), 0));
}

TEST(Graph, keeps_its_numbers_when_copied) {
    Graph g;
    const NodeId sum = g.apply(Op::add, g.variable(graph::variable_x), g.constant(1));
    Graph copy = g;
    const NodeId more = copy.apply(Op::neg, sum);
    EXPECT_EQ(copy[sum].op, Op::add);
    EXPECT_EQ(copy.apply(Op::add, copy.variable(graph::variable_x), copy.constant(1)), sum);
    EXPECT_EQ(graph::index(more), g.size());
}

TEST(Reachable, lists_only_what_the_roots_need_in_increasing_order) {
    Graph g;
    const NodeId x = g.variable(graph::variable_x);
    const NodeId unused = g.constant(7);
    const NodeId y = g.variable(graph::variable_y);
    const NodeId sum = g.apply(Op::add, x, y);
    g.apply(Op::neg, unused);
    const NodeId product = g.apply(Op::mul, sum, sum);
    const NodeId roots[] = {product, sum};
    EXPECT_EQ(graph::reachable(g, roots), (std::vector<NodeId>{x, y, sum, product}));
}

TEST(Reachable, of_no_root_is_empty) {
    Graph g;
    g.constant(1);
    EXPECT_TRUE(graph::reachable(g, {}).empty());
}

/// A graph of random nodes over x, y, z, t and constants.
Graph random_graph(unsigned seed) {
    std::mt19937 random(seed);
    Graph g;
    std::vector<NodeId> nodes{g.variable(graph::variable_x), g.variable(graph::variable_y),
                              g.parameter(graph::parameter_t), g.constant(1), g.constant(-2.5)};
    const auto any = [&] { return nodes[random() % nodes.size()]; };
    while (nodes.size() < 200) {
        const Op op = static_cast<Op>(3 + random() % (graph::operator_count - 3));
        std::vector<NodeId> arguments(static_cast<std::size_t>(graph::facts(op).arity));
        for (NodeId& argument : arguments) argument = any();
        nodes.push_back(g.apply(op, arguments));
    }
    return g;
}

TEST(Reachable, has_arguments_before_their_users) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Graph g = random_graph(seed);
        const NodeId root[] = {static_cast<NodeId>(g.size() - 1)};
        std::vector<bool> seen(g.size(), false);
        for (const NodeId id : graph::reachable(g, root)) {
            EXPECT_FALSE(seen[graph::index(id)]) << "seed " << seed;
            for (const NodeId argument : g[id].args()) {
                EXPECT_TRUE(seen[graph::index(argument)]) << "seed " << seed;
            }
            seen[graph::index(id)] = true;
        }
        EXPECT_TRUE(seen.back()) << "seed " << seed;
    }
}

TEST(DependsOnVariables, is_true_for_what_a_variable_leads_to) {
    Graph g;
    const NodeId x = g.variable(graph::variable_x);
    const NodeId state = g.variable(g.new_variable("state"));
    const NodeId t = g.parameter(graph::parameter_t);
    const NodeId one = g.constant(1);
    const NodeId hoisted = g.apply(Op::sin, g.apply(Op::add, t, one));
    const NodeId scaled = g.apply(Op::mul, hoisted, x);
    const NodeId stepped = g.apply(Op::neg, state);
    const std::vector<bool> depends = graph::depends_on_variables(g);
    ASSERT_EQ(depends.size(), g.size());
    EXPECT_TRUE(depends[graph::index(x)]);
    EXPECT_TRUE(depends[graph::index(scaled)]);
    EXPECT_TRUE(depends[graph::index(stepped)]);
    EXPECT_FALSE(depends[graph::index(t)]);
    EXPECT_FALSE(depends[graph::index(one)]);
    EXPECT_FALSE(depends[graph::index(hoisted)]);
}

TEST(DependsOnVariables, agrees_with_what_is_reachable) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Graph g = random_graph(seed);
        const std::vector<bool> depends = graph::depends_on_variables(g);
        for (std::size_t i = 0; i < g.size(); ++i) {
            const NodeId root[] = {static_cast<NodeId>(i)};
            bool expected = false;
            for (const NodeId id : graph::reachable(g, root)) {
                expected |= g[id].op == Op::variable;
            }
            EXPECT_EQ(depends[i], expected) << "seed " << seed << ", node " << i;
        }
    }
}

}  // namespace
