// SPDX-License-Identifier: MIT
// Constants meet operators.
#include "passes/fold_constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "passes/rule.h"

namespace passes {
namespace {

std::string folded(Expr expression) { return rewritten(fold_constants, expression); }

TEST(FoldConstants, computes_operators_on_constants) {
    Leaves l;
    EXPECT_EQ(folded(l.number(2) + 3.0), "5");
    EXPECT_EQ(folded(sqrt(l.number(2))), graph::shortest(std::sqrt(2.0)));
    EXPECT_EQ(folded(pow(l.number(-2), l.number(3))), "-8");
    EXPECT_EQ(folded(select_less(l.number(1), l.number(2), l.number(7), l.number(9))), "7");
}

TEST(FoldConstants, computes_the_constant_parts_of_an_expression) {
    Leaves l;
    EXPECT_EQ(folded(l.x * (l.number(1) + 2.0) + sin(l.number(0))), "add(mul(x, 3), 0)");
    EXPECT_EQ(folded(l.t * 2.0), "mul(t, 2)") << "a parameter is no constant";
}

TEST(FoldConstants, keeps_a_division_by_zero) {
    Leaves l;
    EXPECT_EQ(folded(l.number(1) / 0.0), "div(1, 0)");
    EXPECT_EQ(folded(l.number(0) / 0.0), "div(0, 0)");
}

TEST(FoldConstants, keeps_what_is_undefined_or_overflows) {
    Leaves l;
    EXPECT_EQ(folded(sqrt(l.number(-1))), "sqrt(-1)");
    EXPECT_EQ(folded(log(l.number(0))), "log(0)");
    EXPECT_EQ(folded(exp(l.number(1000))), "exp(1000)");
    EXPECT_EQ(folded(l.x + (l.number(1) / 0.0)), "add(x, div(1, 0))");
}

TEST(FoldConstants, folds_every_operator_on_ones) {
    graph::for_each_operator([](Op op) {
        graph::Graph g;
        const std::vector<graph::NodeId> ones(static_cast<std::size_t>(graph::facts(op).arity),
                                              g.constant(1));
        const graph::NodeId id = rewrite(g, std::array{g.apply(op, ones)}, fold_constants)[0];
        EXPECT_TRUE(g.is_constant(id)) << graph::facts(op).name;
    });
}

}  // namespace
}  // namespace passes
