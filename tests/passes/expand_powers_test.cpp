// SPDX-License-Identifier: MIT
// Powers become products where the exponent is a small whole number.
#include "passes/expand_powers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "eval/tape.h"
#include "passes/rule.h"

namespace passes {
namespace {

std::string expanded(Expr expression) { return transformed(expand_powers, expression); }

int count_operators(const graph::Graph& g, graph::NodeId root) {
    int count = 0;
    for (const graph::NodeId id : reachable(g, std::array{root})) count += !g[id].args().empty();
    return count;
}

TEST(ExpandPowers, multiplies_for_whole_exponents_up_to_64) {
    for (int n = 0; n <= 64; ++n) {
        Leaves l;
        const Expr power = pow(l.x, l.number(n));
        const graph::NodeId id = expand_powers(l.graph, std::array{power.id})[0];
        for (const graph::NodeId used : reachable(l.graph, std::array{id})) {
            EXPECT_NE(l.graph[used].op, Op::pow) << "x^" << n;
        }
        EXPECT_LE(count_operators(l.graph, id), 8) << "x^" << n;
        for (const double x : {-1.25, -1.0, 0.0, 0.75, 1.5}) {
            const double expected = std::pow(x, n);
            EXPECT_NEAR(eval::evaluate(l.graph, id, {x, 0, 0}), expected,
                        1e-14 * std::abs(expected))
                << x << "^" << n;
        }
    }
}

TEST(ExpandPowers, squares_repeatedly) {
    Leaves l;
    EXPECT_EQ(expanded(pow(l.x, l.number(1))), "x");
    EXPECT_EQ(expanded(pow(l.x, l.number(2))), "mul(x, x)");
    EXPECT_EQ(expanded(pow(l.x, l.number(3))), "mul(mul(x, x), x)");
    EXPECT_EQ(expanded(pow(l.x, l.number(4))), "mul(mul(x, x), mul(x, x))");
}

TEST(ExpandPowers, takes_the_shortest_chain) {
    const auto multiplications = [](int n) {
        Leaves l;
        const Expr power = pow(l.x, l.number(n));
        return count_operators(l.graph, expand_powers(l.graph, std::array{power.id})[0]);
    };
    EXPECT_EQ(multiplications(15), 5);
    EXPECT_EQ(multiplications(23), 6);
    EXPECT_EQ(multiplications(63), 8);
}

TEST(ExpandPowers, shares_powers_of_one_base) {
    Leaves l;
    const auto power = [&](Expr base, int n) { return pow(base, l.number(n)); };
    const Expr base = l.x + l.y;
    const std::array roots{power(base, 6).id, power(base, 4).id, power(base, 2).id,
                           power(l.z, 15).id};
    std::vector<graph::NodeId> after = expand_powers(l.graph, roots);
    const graph::NodeId last = after.back();
    after.pop_back();
    int count = 0;
    for (const graph::NodeId id : reachable(l.graph, after)) count += l.graph[id].op == Op::mul;
    EXPECT_EQ(count, 3);
    EXPECT_EQ(count_operators(l.graph, last), 5);
}

TEST(ExpandPowers, joins_powers_of_powers_and_products_of_powers) {
    Leaves l;
    const Expr square = pow(l.x, l.number(2));
    EXPECT_EQ(expanded(pow(square, l.number(2))), "mul(mul(x, x), mul(x, x))");
    EXPECT_EQ(expanded(square * l.x * square), expanded(pow(l.x, l.number(5))));
    EXPECT_EQ(expanded(pow(square, l.number(-1))), "div(1, mul(x, x))");
}

TEST(ExpandPowers, divides_for_negative_exponents) {
    Leaves l;
    EXPECT_EQ(expanded(pow(l.x, l.number(-1))), "div(1, x)");
    EXPECT_EQ(expanded(pow(l.x, l.number(-2))), "div(1, mul(x, x))");
    const graph::NodeId id = expand_powers(l.graph, std::array{pow(l.x, l.number(-3)).id})[0];
    EXPECT_EQ(eval::evaluate(l.graph, id, {-2, 0, 0}), -0.125);
    EXPECT_EQ(eval::evaluate(l.graph, id, {0, 0, 0}), INFINITY);
}

TEST(ExpandPowers, takes_roots_for_halves) {
    Leaves l;
    EXPECT_EQ(expanded(pow(l.x, l.number(0.5))), "sqrt(x)");
    EXPECT_EQ(expanded(pow(l.x, l.number(-0.5))), "div(1, sqrt(x))");
}

TEST(ExpandPowers, keeps_all_other_exponents) {
    Leaves l;
    EXPECT_EQ(expanded(pow(l.x, l.number(2.5))), "pow(x, 2.5)");
    EXPECT_EQ(expanded(pow(l.x, l.number(65))), "pow(x, 65)");
    EXPECT_EQ(expanded(pow(l.x, l.number(-65))), "pow(x, -65)");
    EXPECT_EQ(expanded(pow(l.x, l.t)), "pow(x, t)");
    EXPECT_EQ(expanded(pow(l.x, l.number(INFINITY))), "pow(x, inf)");
}

TEST(ExpandPowers, keeps_a_power_of_zero_whose_base_may_be_undefined) {
    Leaves l;
    EXPECT_EQ(expanded(pow(l.x, l.number(0))), "1");
    EXPECT_EQ(expanded(pow(log(l.x), l.number(0))), "pow(log(x), 0)");
}

}  // namespace
}  // namespace passes
