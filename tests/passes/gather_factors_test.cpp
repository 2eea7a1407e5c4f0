// SPDX-License-Identifier: MIT
// Products: constants and parameters first, signs and powers out.
#include "passes/gather_factors.h"

#include <gtest/gtest.h>

#include "passes/rule.h"

namespace passes {
namespace {

std::string gathered(Expr expression) { return transformed(gather_factors, expression); }

TEST(GatherFactors, puts_constants_and_parameters_together) {
    Leaves l;
    EXPECT_EQ(gathered(2.0 * l.t * l.x * l.t), "mul(mul(2, pow(t, 2)), x)");
    EXPECT_EQ(gathered(2.0 * (l.x * 3.0)), "mul(6, x)");
    EXPECT_EQ(gathered(l.x * l.t * (l.y * 0.5)), "mul(mul(0.5, t), mul(x, y))");
}

TEST(GatherFactors, takes_signs_out) {
    Leaves l;
    EXPECT_EQ(gathered(-l.x * l.y), "neg(mul(x, y))");
    EXPECT_EQ(gathered(-l.x * (2.0 * l.y)), "mul(mul(-2, x), y)");
    EXPECT_EQ(gathered(-l.x * l.y * l.t), "mul(neg(t), mul(x, y))") << "once a frame";
}

TEST(GatherFactors, makes_powers_of_equal_factors) {
    Leaves l;
    EXPECT_EQ(gathered(l.x * l.y * l.x), "mul(y, pow(x, 2))");
    const Expr cube = pow(l.x, l.number(3));
    EXPECT_EQ(gathered(l.x * l.y * cube), "mul(y, pow(x, 4))");
}

TEST(GatherFactors, leaves_products_alone_where_nothing_is_saved) {
    Leaves l;
    EXPECT_EQ(gathered(l.z * (l.y * l.x)), "mul(z, mul(y, x))");
    EXPECT_EQ(gathered((2.0 * l.x) * l.y), "mul(mul(2, x), y)");
    EXPECT_EQ(gathered(l.t * (2.0 * l.t)), "mul(t, mul(2, t))") << "the same for all points";
}

TEST(GatherFactors, takes_nothing_apart_that_is_used_twice) {
    Leaves l;
    const Expr twice = 2.0 * l.x;
    EXPECT_EQ(gathered(sin(twice) + 3.0 * twice), "add(sin(mul(2, x)), mul(3, mul(2, x)))");
}

TEST(GatherFactors, keeps_products_with_zero_and_infinity) {
    Leaves l;
    EXPECT_EQ(gathered(0.0 * (2.0 * log(l.x))), "mul(0, mul(2, log(x)))");
    EXPECT_EQ(gathered(1e300 * (1e300 * l.x)), "mul(1e+300, mul(1e+300, x))");
}

TEST(GatherFactors, multiplies_before_a_loop_what_stays_in_it) {
    Leaves l;
    const Expr state(l.graph, l.graph.variable(l.graph.new_variable("s")));
    EXPECT_EQ(gathered(l.x * state * l.y), "mul(mul(x, y), s)");
}

}  // namespace
}  // namespace passes
