// SPDX-License-Identifier: MIT
// What expressions and trees depend on, and what they cost.
#include "analysis/dependence.h"

#include <gtest/gtest.h>

#include "analysis/cost.h"
#include "graph/build.h"

namespace analysis {
namespace {

using field::Field;
using field::FieldId;
using graph::Expr;

struct Scene {
    Field field;
    graph::ParameterId p = field.graph.new_parameter("p"), q = field.graph.new_parameter("q");
    Expr x{field.graph, field.graph.variable(graph::variable_x)};
    Expr y{field.graph, field.graph.variable(graph::variable_y)};
    Expr z{field.graph, field.graph.variable(graph::variable_z)};
    Expr time{field.graph, field.graph.parameter(graph::parameter_t)};

    Expr parameter(graph::ParameterId id) { return {field.graph, field.graph.parameter(id)}; }
    FieldId solid(Expr value) { return field.add(field::Formula{value.id}); }
};

TEST(Dependence, of_an_expression) {
    Scene s;
    const Expr f = s.x * s.parameter(s.q) + s.z;
    const Dependence found = dependence(s.field.graph, std::array{f.id});
    EXPECT_EQ(found.point, (std::array{true, false, true}));
    EXPECT_FALSE(found.time);
    EXPECT_EQ(found.parameters, std::vector{s.q});
    EXPECT_TRUE(found.on_point());
    EXPECT_TRUE(found.on_parameters());
}

TEST(Dependence, on_time_is_told_apart_from_parameters) {
    Scene s;
    const Dependence found = dependence(s.field.graph, std::array{sin(s.time).id});
    EXPECT_TRUE(found.time);
    EXPECT_TRUE(found.parameters.empty());
    EXPECT_FALSE(found.on_point());
    EXPECT_TRUE(found.on_parameters());
}

TEST(Dependence, of_a_tree_is_that_of_all_below) {
    Scene s;
    const FieldId a = s.solid(s.x * s.parameter(s.q)), b = s.solid(s.y + s.parameter(s.p));
    const FieldId blended = s.field.add(field::Choice{s.time.id, s.time.id, a, b});
    const Dependence found = dependence(s.field, s.field.add(field::Complement{blended}));
    EXPECT_EQ(found.point, (std::array{true, true, false}));
    EXPECT_TRUE(found.time);
    EXPECT_EQ(found.parameters, (std::vector{s.p, s.q}));
    EXPECT_EQ(dependence(s.field, a).parameters, std::vector{s.q});
}

/// A loop over one number: from x + y, squared and x added, until it is above 4.
field::Iteration loop(Scene& s, Expr limit) {
    const graph::VariableId v = s.field.graph.new_variable("v");
    const Expr state(s.field.graph, s.field.graph.variable(v));
    return {{v},      {(s.x + s.y).id}, {(state * state + s.x).id},
            limit.id, (state - 4.0).id, (log(state) * 2.0 + s.x).id};
}

TEST(Dependence, of_an_iteration_leaves_its_state_out) {
    Scene s;
    const Dependence found = dependence(s.field, s.field.add(loop(s, s.parameter(s.p))));
    EXPECT_EQ(found.point, (std::array{true, true, false}));
    EXPECT_EQ(found.parameters, std::vector{s.p});
}

TEST(Cost, counts_shared_operations_once_and_hoisted_ones_apart) {
    Scene s;
    const Expr square = s.x * s.x, hoisted = sin(s.parameter(s.p)) + 1.0;
    const Cost found = cost(s.field, s.solid(square + square * s.y - hoisted));
    EXPECT_EQ(found.point, 4u);    // the square, its product, the sum, the difference
    EXPECT_EQ(found.hoisted, 2u);  // the sine and its sum
    EXPECT_EQ(found.turn, 0u);
}

TEST(Cost, of_a_tree_counts_what_each_leaf_computes_and_the_joints) {
    Scene s;
    const FieldId a = s.solid(s.x * s.x), b = s.solid(s.x * s.x + s.y);
    EXPECT_EQ(cost(s.field, s.field.add(field::Union{a, b})).point, 1u + 2u + 1u);
}

TEST(Cost, of_an_iteration_tells_its_turn_apart) {
    Scene s;
    const Cost found = cost(s.field, s.field.add(loop(s, Expr(s.field.graph, 5))));
    EXPECT_EQ(found.point, 1u + 3u);
    EXPECT_EQ(found.turn, 2u + 1u);
}

}  // namespace
}  // namespace analysis
