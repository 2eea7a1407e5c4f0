// SPDX-License-Identifier: MIT
// Sums: what is the same for all points is added up once.
#include "passes/gather_terms.h"

#include <gtest/gtest.h>

#include "passes/rule.h"

namespace passes {
namespace {

std::string gathered(Expr expression) { return transformed(gather_terms, expression); }

TEST(GatherTerms, adds_constants_and_parameters_first) {
    Leaves l;
    EXPECT_EQ(gathered(l.x + 1.0 + l.y - l.t), "add(add(x, y), sub(1, t))");
    EXPECT_EQ(gathered((l.x - 1.0) - (l.t + 2.0)), "sub(x, add(add(1, t), 2))");
    EXPECT_EQ(gathered((1.0 - l.x) - 3.0 - l.y), "sub(sub(1, 3), add(x, y))");
}

TEST(GatherTerms, leaves_other_sums_as_they_are) {
    Leaves l;
    EXPECT_EQ(gathered(l.x + 1.0 + l.y), "add(add(x, 1), y)");
    EXPECT_EQ(gathered(l.x - (l.y - l.z)), "sub(x, sub(y, z))");
    EXPECT_EQ(gathered((l.t + 1.0) + l.t), "add(add(t, 1), t)");
}

TEST(GatherTerms, takes_nothing_apart_that_is_used_twice) {
    Leaves l;
    const Expr sum = l.x + 1.0;
    EXPECT_EQ(gathered(sin(sum) + (sum + 2.0)), "add(sin(add(x, 1)), add(add(x, 1), 2))");
}

TEST(GatherTerms, adds_before_a_loop_what_stays_in_it) {
    Leaves l;
    const Expr state(l.graph, l.graph.variable(l.graph.new_variable("s")));
    EXPECT_EQ(gathered(l.x + state * state + l.y), "add(mul(s, s), add(x, y))");
}

}  // namespace
}  // namespace passes
