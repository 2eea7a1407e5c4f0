// SPDX-License-Identifier: MIT
// a * b and b * a.
#include "passes/order_operands.h"

#include <gtest/gtest.h>

#include "passes/pipeline.h"
#include "passes/rule.h"

namespace passes {
namespace {

std::string ordered(Expr expression) { return rewritten(order_operands, expression); }

TEST(OrderOperands, goes_from_constants_to_operators) {
    Leaves l;
    EXPECT_EQ(ordered(l.x * 2.0), "mul(2, x)");
    EXPECT_EQ(ordered(l.x + l.t), "add(t, x)");
    EXPECT_EQ(ordered(l.z + l.x), "add(x, z)");
    EXPECT_EQ(ordered(sin(l.x) * l.y), "mul(y, sin(x))");
    EXPECT_EQ(ordered(hypot(l.y, l.x)), "hypot(x, y)");
}

TEST(OrderOperands, makes_one_node_of_both_orders) {
    Leaves l;
    const Expr wave = sin(l.y), other = cos(l.z);
    const std::array roots{(wave * other).id, (other * wave).id, (l.x * wave + 1.0).id,
                           (1.0 + wave * l.x).id};
    const std::vector<graph::NodeId> after = rewrite(l.graph, roots, order_operands);
    EXPECT_EQ(after[0], after[1]);
    EXPECT_EQ(after[2], after[3]);
}

TEST(OrderOperands, keeps_what_does_not_commute) {
    Leaves l;
    EXPECT_EQ(ordered(l.y - l.x), "sub(y, x)");
    EXPECT_EQ(ordered(atan2(l.y, l.x)), "atan2(y, x)");
    EXPECT_EQ(ordered(min(l.y, l.x)), "min(y, x)") << "whose derivative depends on the order";
}

}  // namespace
}  // namespace passes
