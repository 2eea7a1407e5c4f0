// SPDX-License-Identifier: MIT
// The parts of the tree's nodes.
#include "field/parts.h"

#include <gtest/gtest.h>

#include "field/map_domain.h"
#include "field/shapes.h"
#include "graph/build.h"

namespace field {
namespace {

using graph::Expr;
using graph::NodeId;

struct Loop {
    Field field;
    FieldId id{};

    Loop() {
        graph::Graph& g = field.graph;
        const graph::VariableId a = g.new_variable("a"), trap = g.new_variable("trap");
        const Expr x(g, g.variable(graph::variable_x)), state(g, g.variable(a));
        const Expr seen(g, g.variable(trap));
        Iteration loop{{a, trap},
                       {x.id, g.constant(9)},
                       {(state * state).id, min(seen, state).id},
                       g.constant(5),
                       (state - 4.0).id,
                       log(state).id,
                       Colour{seen.id, x.id, x.id}};
        id = field.add(std::move(loop));
    }
};

TEST(Parts, are_all_expressions_of_a_node_in_the_order_of_their_places) {
    Loop loop;
    Node node = loop.field[loop.id];
    const std::vector<NodeId> list = expressions(loop.field[loop.id]);
    const std::vector<NodeId*> places = expressions(node);
    EXPECT_EQ(list.size(), 2u + 2u + 1u + 1u + 1u + 3u);
    ASSERT_EQ(places.size(), list.size());
    for (std::size_t i = 0; i < list.size(); ++i) EXPECT_EQ(*places[i], list[i]);
    *places[0] = loop.field.graph.constant(3);
    EXPECT_EQ(std::get<Iteration>(node).start[0], loop.field.graph.constant(3));
}

TEST(Parts, of_a_shape_leave_out_what_only_the_colour_needs) {
    Loop loop;
    const Node node = shape(loop.field, loop.id);
    const auto& iteration = std::get<Iteration>(node);
    EXPECT_EQ(iteration.state.size(), 1u);
    EXPECT_EQ(iteration.step.size(), 1u);
    EXPECT_EQ(iteration.start.size(), 1u);
    EXPECT_FALSE(iteration.colour);
    EXPECT_EQ(expressions(node).size(), 5u);
}

TEST(Parts, of_a_shape_leave_out_what_only_a_lipschitz_constant_is_found_from) {
    Field field;
    const FieldId ball = add_primitive(field, "sphere", {1});
    const FieldId twisted = turn_domain(field, ball, field.graph.variable(graph::variable_z));
    EXPECT_GT(expressions(field[twisted]).size(), 1u);
    EXPECT_EQ(expressions(shape(field, twisted)).size(), 1u);
}

TEST(Parts, below_a_node_are_its_children) {
    Field field;
    const graph::NodeId zero = field.graph.constant(0), one = field.graph.constant(1);
    const FieldId a = add_primitive(field, "sphere", {1}), b = add_primitive(field, "sphere", {2});
    EXPECT_TRUE(children(field[a]).empty());
    EXPECT_EQ(children(Union{a, b}), (std::vector{a, b}));
    EXPECT_EQ(children(Complement{b}), std::vector{b});
    EXPECT_EQ(children(Choice{zero, one, a, b}), (std::vector{a, b}));
    EXPECT_EQ(expressions(Choice{zero, one, a, b}), (std::vector{zero, one}));
}

}  // namespace
}  // namespace field
