// SPDX-License-Identifier: MIT
// Colours of leaves: where they are kept, moved and evaluated.
#include <gtest/gtest.h>

#include <cmath>

#include "field/blends.h"
#include "field/map_domain.h"
#include "field/palette.h"
#include "field/print_field.h"
#include "field/shapes.h"
#include "graph/build.h"

namespace field {
namespace {

Colour of_point(Field& f) {
    return {f.graph.variable(graph::variable_x), f.graph.variable(graph::variable_y),
            f.graph.constant(0.5)};
}

glm::dvec3 colour_at(const Field& f, FieldId leaf, glm::dvec3 p) {
    const auto colour = eval::colour(f, leaf, p, {});
    EXPECT_TRUE(colour);
    return colour.value_or(glm::dvec3(-1));
}

TEST(Colour, counts_negative_and_undefined_parts_as_nothing) {
    Field f;
    const FieldId id = coloured(f, add_primitive(f, "sphere", {1}), of_point(f));
    EXPECT_EQ(colour_at(f, id, {0.25, -1, 0}), glm::dvec3(0.25, 0, 0.5));
    const graph::Expr x(f.graph, f.graph.variable(graph::variable_x));
    const Colour undefined{log(x).id, x.id, x.id};
    EXPECT_EQ(colour_at(f, coloured(f, id, undefined), {-1, 0, 0}), glm::dvec3(0, 0, 0));
}

TEST(Colour, is_that_of_every_leaf_below) {
    Field f;
    const FieldId both = f.add(
        Union{add_primitive(f, "sphere", {1}), f.add(Complement{add_primitive(f, "sphere", {2})})});
    for (const FieldId leaf : leaves(f, both)) EXPECT_FALSE(eval::colour(f, leaf, {}, {}));
    for (const FieldId leaf : leaves(f, coloured(f, both, of_point(f)))) {
        EXPECT_EQ(colour_at(f, leaf, {0.1, 0.2, 0}), glm::dvec3(0.1, 0.2, 0.5));
    }
}

TEST(Colour, moves_with_the_shape) {
    Field f;
    const FieldId id = coloured(f, add_primitive(f, "sphere", {1}), of_point(f));
    const graph::Expr x(f.graph, f.graph.variable(graph::variable_x));
    const FieldId moved = map_domain(
        f, id,
        {(x - 3.0).id, f.graph.variable(graph::variable_y), f.graph.variable(graph::variable_z)},
        f.graph.constant(1));
    EXPECT_EQ(colour_at(f, moved, {3.25, 0.5, 0}), glm::dvec3(0.25, 0.5, 0.5));
}

TEST(Colour, is_not_lost_in_a_smooth_union) {
    Field f;
    const FieldId red = coloured(f, add_primitive(f, "sphere", {1}), of_point(f));
    const FieldId plain = add_primitive(f, "sphere", {2});
    const auto list = leaves(f, smooth_union(f, red, plain, f.graph.constant(0.2)));
    ASSERT_EQ(list.size(), 2U);
    EXPECT_TRUE(eval::colour(f, list[0], {}, {}));
    EXPECT_FALSE(eval::colour(f, list[1], {}, {}));
}

TEST(Colour, of_an_iteration_is_that_of_its_last_state) {
    Field f;
    const graph::VariableId id = f.graph.new_variable("u");
    const graph::Expr u(f.graph, f.graph.variable(id));
    const graph::NodeId x = f.graph.variable(graph::variable_x);
    const graph::NodeId four = f.graph.constant(4);
    // Doubles until u > 10, at most four times.
    const FieldId leaf = f.add(Iteration{.state = {id},
                                         .start = {x},
                                         .step = {(2.0 * u).id},
                                         .limit = four,
                                         .escape = (u - 10.0).id,
                                         .distance = u.id,
                                         .colour = Colour{u.id, x, four}});
    EXPECT_EQ(colour_at(f, leaf, {3, 0, 0}), glm::dvec3(12, 3, 4));
    EXPECT_EQ(colour_at(f, leaf, {0.5, 0, 0}), glm::dvec3(8, 0.5, 4)) << "never escapes";
}

TEST(Colour, stands_in_the_text_of_a_field) {
    Field f;
    f.root = coloured(f, add_primitive(f, "sphere", {1}), of_point(f));
    EXPECT_NE(print(f).find("red: "), std::string::npos);
    EXPECT_EQ(print(primitive("sphere", {1})).find("red: "), std::string::npos);
}

TEST(Palette, comes_back_after_one_and_stays_between_0_and_1) {
    Field f;
    const Colour colour = palette(f.graph, f.graph.variable(graph::variable_x));
    const FieldId id = coloured(f, add_primitive(f, "sphere", {1}), colour);
    for (double phase = 0; phase < 1; phase += 1.0 / 64) {
        const glm::dvec3 here = colour_at(f, id, {phase, 0, 0});
        EXPECT_LT(glm::distance(here, colour_at(f, id, {phase + 3, 0, 0})), 1e-12);
        for (int i = 0; i < 3; ++i) {
            EXPECT_GT(here[i], 0.02);
            EXPECT_LT(here[i], 0.98);
        }
    }
}

TEST(NeededState, is_what_answers_need_through_the_steps) {
    Field f;
    std::vector<graph::VariableId> state;
    std::vector<graph::NodeId> node;
    for (const char* name : {"a", "b", "c", "d"}) {
        state.push_back(f.graph.new_variable(name));
        node.push_back(f.graph.variable(state.back()));
    }
    // a <- b, b <- b, c <- a, d <- d
    const Iteration iteration{.state = state,
                              .start = node,
                              .step = {node[1], node[1], node[0], node[3]},
                              .limit = f.graph.constant(3),
                              .escape = std::nullopt,
                              .distance = node[0]};
    using List = std::vector<bool>;
    EXPECT_EQ(needed_state(f.graph, iteration, std::array{node[0]}),
              (List{true, true, false, false}));
    EXPECT_EQ(needed_state(f.graph, iteration, std::array{node[2]}),
              (List{true, true, true, false}));
    Iteration escaping = iteration;
    escaping.escape = node[3];
    EXPECT_EQ(needed_state(f.graph, escaping, std::array{node[1]}),
              (List{false, true, false, true}));
}

}  // namespace
}  // namespace field
