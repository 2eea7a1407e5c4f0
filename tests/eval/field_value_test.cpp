// SPDX-License-Identifier: MIT
// Values of whole fields with known answers.
#include "eval/field_value.h"

#include <cmath>

#include <gtest/gtest.h>

#include "field/blends.h"
#include "field/palette.h"
#include "graph/build.h"

namespace eval {
namespace {

using field::Field;
using field::FieldId;
using graph::Expr;

constexpr double infinity = std::numeric_limits<double>::infinity();

Expr variable(Field& f, graph::VariableId id) { return {f.graph, f.graph.variable(id)}; }
Expr x_of(Field& f) { return variable(f, graph::variable_x); }

/// The half-space x <= at.
FieldId half_space(Field& f, double at) {
    return f.add(field::Formula{.value = (x_of(f) - at).id});
}

double at_x(const Field& f, FieldId id, double x) { return value(f, id, {x, 0, 0}, {}); }

TEST(FieldValue, combines_by_minimum_maximum_and_sign) {
    Field f;
    const FieldId a = half_space(f, 1), b = half_space(f, 3);
    EXPECT_EQ(at_x(f, f.add(field::Union{a, b}), 2), -1);
    EXPECT_EQ(at_x(f, f.add(field::Intersection{a, b}), 2), 1);
    EXPECT_EQ(at_x(f, f.add(field::Complement{a}), 2), -1);
}

/// The smooth union of two formulas that are not composed: one of them has a colour.
FieldId apart(Field& f, FieldId a, FieldId b, double k) {
    const FieldId red = field::coloured(f, a, field::coordinates(f.graph));
    return smooth_union(f, red, b, f.graph.constant(k));
}

TEST(FieldValue, smooth_union_blends_over_its_width) {
    Field f;
    const FieldId a = half_space(f, 0), b = f.add(field::Formula{.value = (-x_of(f)).id});
    const FieldId blend = apart(f, a, b, 2);
    EXPECT_EQ(at_x(f, blend, 0), -0.5) << "a quarter of the width below the corner";
    EXPECT_EQ(at_x(f, blend, 1), -1);
    EXPECT_EQ(at_x(f, blend, 3), -3);
}

TEST(FieldValue, outside_the_domain_of_a_solid_is_outside) {
    Field f;
    const Expr root = sqrt(x_of(f)) - 1.0;
    const FieldId solid = f.add(field::Formula{.value = root.id});
    const FieldId sheet = f.add(field::Formula{.value = root.id, .kind = field::Kind::sheet});
    const FieldId other = half_space(f, 0);
    EXPECT_EQ(at_x(f, solid, -1), infinity);
    EXPECT_EQ(at_x(f, f.add(field::Union{solid, other}), -1), -1);
    EXPECT_EQ(at_x(f, f.add(field::Complement{solid}), -1), -infinity);
    EXPECT_EQ(at_x(f, apart(f, solid, other, 1), -1), -1);
    EXPECT_TRUE(std::isnan(at_x(f, sheet, -1)));
}

/// Repeats u <- 2 u from u = x while u <= 10, at most `limit` times; the answer is u.
FieldId doubling(Field& f, graph::NodeId limit) {
    const graph::VariableId state = f.graph.new_variable("u");
    const Expr u = variable(f, state);
    return f.add(field::Iteration{.state = {state},
                                  .start = {x_of(f).id},
                                  .step = {(2.0 * u).id},
                                  .limit = limit,
                                  .escape = (u - 10.0).id,
                                  .distance = u.id});
}

TEST(FieldValue, iterations_run_until_they_escape) {
    Field f;
    const FieldId id = doubling(f, f.graph.constant(4));
    EXPECT_EQ(at_x(f, id, 3), 12);
    EXPECT_EQ(at_x(f, id, 0.75), 12) << "escapes by the last step";
    EXPECT_EQ(at_x(f, id, 11), 11) << "has escaped before the first step";
    EXPECT_EQ(at_x(f, id, 0.5), -infinity) << "never escapes";
}

TEST(FieldValue, the_limit_of_an_iteration_is_rounded_to_the_nearest_number) {
    Field f;
    const graph::ParameterId n = f.graph.new_parameter("n");
    const FieldId id = doubling(f, f.graph.parameter(n));
    EXPECT_EQ(value(f, id, {3, 0, 0}, std::array{0.0, 1.6}), 12);
    EXPECT_EQ(value(f, id, {3, 0, 0}, std::array{0.0, 1.4}), -infinity);
}

TEST(FieldValue, steps_change_all_state_at_once) {
    Field f;
    const graph::VariableId first = f.graph.new_variable("a"), second = f.graph.new_variable("b");
    const Expr a = variable(f, first), b = variable(f, second);
    // Fibonacci's numbers: (a, b) <- (b, a + b).
    const FieldId id = f.add(field::Iteration{.state = {first, second},
                                              .start = {f.graph.constant(0), f.graph.constant(1)},
                                              .step = {b.id, (a + b).id},
                                              .limit = f.graph.constant(10),
                                              .escape = std::nullopt,
                                              .distance = a.id});
    EXPECT_EQ(at_x(f, id, 0), 55);
}

}  // namespace
}  // namespace eval
