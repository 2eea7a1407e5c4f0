// SPDX-License-Identifier: MIT
// The derivative along a ray against the gradient and the Hessian.
#include "passes/derivative_along.h"

#include <gtest/gtest.h>

#include "eval/tape.h"
#include "passes/differentiate.h"
#include "passes/rule.h"

namespace passes {
namespace {

TEST(DerivativeAlong, is_the_gradient_times_the_direction) {
    Leaves l;
    const Expr f = sin(l.x * l.y) + l.z * l.z * l.x;
    const std::array direction{l.number(0.6).id, l.number(-0.8).id, l.t.id};
    const graph::NodeId slope = derivative_along(l.graph, f.id, direction);
    const auto g = gradient(l.graph, f.id);
    const glm::dvec3 p(0.3, -1.2, 0.7);
    const std::array time{2.5};
    const auto value = [&](graph::NodeId id) { return eval::evaluate(l.graph, id, p, time); };
    EXPECT_NEAR(value(slope), 0.6 * value(g[0]) - 0.8 * value(g[1]) + 2.5 * value(g[2]), 1e-14);
}

TEST(DerivativeAlong, twice_is_the_second_derivative) {
    Leaves l;
    const Expr f = l.x * l.x * l.y;  // xx: 2y, xy: 2x
    const std::array direction{l.number(3).id, l.number(4).id, l.number(0).id};
    const graph::NodeId once = derivative_along(l.graph, f.id, direction);
    const graph::NodeId twice = derivative_along(l.graph, once, direction);
    EXPECT_DOUBLE_EQ(eval::evaluate(l.graph, twice, {2, 5, 0}), 9 * 2 * 5 + 2 * 3 * 4 * 2 * 2);
}

TEST(DerivativeAlong, is_zero_across_the_direction) {
    Leaves l;
    const std::array direction{l.number(0).id, l.number(0).id, l.number(1).id};
    EXPECT_EQ(in_one_line(l.graph, derivative_along(l.graph, (l.x * l.y).id, direction)), "0");
}

}  // namespace
}  // namespace passes
