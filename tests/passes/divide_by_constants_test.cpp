// SPDX-License-Identifier: MIT
// Reciprocals, where they are exact and where they are not.
#include "passes/divide_by_constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "eval/random_expression.h"
#include "eval/tape.h"
#include "passes/rule.h"

namespace passes {
namespace {

std::string divided(Expr expression) { return transformed(divide_by_constants, expression); }

TEST(DivideByConstants, multiplies_by_the_reciprocal) {
    Leaves l;
    EXPECT_EQ(divided(l.x / 4.0), "mul(0.25, x)");
    EXPECT_EQ(divided(l.x / l.t), "mul(div(1, t), x)");
}

TEST(DivideByConstants, keeps_other_divisions) {
    Leaves l;
    EXPECT_EQ(divided(1.0 / l.x), "div(1, x)");
    EXPECT_EQ(divided(l.t / 3.0), "div(t, 3)") << "once a frame";
    EXPECT_EQ(divided(l.x / 0.0), "div(x, 0)");
    EXPECT_EQ(divided(l.x / l.number(INFINITY)), "div(x, inf)");
    EXPECT_EQ(divided(l.x / 1e-310), "div(x, 1e-310)") << "whose reciprocal is infinite";
}

TEST(DivideByConstants, is_exact_for_powers_of_two_and_within_one_and_a_half_ulps_else) {
    constexpr unsigned seed = 99;
    eval::Random random(seed);
    for (int trial = 0; trial < 20000; ++trial) {
        const int k = static_cast<int>(random() % 200) - 100;
        const double x = eval::ordinary_number(random), c = eval::ordinary_number(random);
        const double power = std::ldexp(1.0, k);
        EXPECT_EQ(x / power, x * (1 / power)) << "seed " << seed;
        if (c == 0) continue;
        const double quotient = x / c;
        EXPECT_LE(std::abs(x * (1 / c) - quotient),
                  1.5 * std::numeric_limits<double>::epsilon() * std::abs(quotient))
            << "seed " << seed << ", " << x << " / " << c;
    }
}

TEST(DivideByConstants, is_undefined_where_it_was) {
    Leaves l;
    const Expr quotient = l.x / l.t;
    const graph::NodeId after = divide_by_constants(l.graph, std::array{quotient.id})[0];
    for (const double t : {0.0, -0.0, 1e-300, 3.0, std::nan("")}) {
        for (const double x : {0.0, 1.0, -2.0, HUGE_VAL}) {
            const auto value = [&](graph::NodeId id) {
                return eval::evaluate(l.graph, id, {x, 0, 0}, std::array{t});
            };
            EXPECT_EQ(std::isnan(value(quotient.id)), std::isnan(value(after))) << x << " / " << t;
        }
    }
}

}  // namespace
}  // namespace passes
