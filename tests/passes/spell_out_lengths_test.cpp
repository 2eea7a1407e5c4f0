// SPDX-License-Identifier: MIT
// Lengths as roots of sums of squares.
#include "passes/spell_out_lengths.h"

#include <gtest/gtest.h>

#include "passes/rule.h"

namespace passes {
namespace {

std::string spelt(Expr expression) { return rewritten(spell_out_lengths, expression); }

TEST(SpellOutLengths, writes_roots_of_sums_of_squares) {
    Leaves l;
    EXPECT_EQ(spelt(hypot(l.x, l.y)), "sqrt(add(mul(x, x), mul(y, y)))");
    EXPECT_EQ(spelt(hypot(l.x, l.y, l.z)), "sqrt(add(add(mul(x, x), mul(y, y)), mul(z, z)))");
}

TEST(SpellOutLengths, needs_no_root_for_the_square_of_a_length) {
    Leaves l;
    EXPECT_EQ(spelt(hypot(l.x, l.y) * hypot(l.x, l.y)), "add(mul(x, x), mul(y, y))");
    EXPECT_EQ(spelt(sqrt(l.x) * sqrt(l.x)), "mul(sqrt(x), sqrt(x))") << "undefined for x < 0";
}

TEST(SpellOutLengths, divides_a_product_of_two_components_once) {
    Leaves l;
    const Expr r = hypot(l.x, l.y);
    const std::string reciprocal = "div(1, max(add(mul(x, x), mul(y, y)), 1e-36))";
    EXPECT_EQ(spelt(ratio(l.x, r) * ratio(l.x, r)), "mul(mul(x, x), " + reciprocal + ")");
    EXPECT_EQ(spelt((2.0 * ratio(l.x, r)) * ratio(l.y, r)),
              "mul(mul(2, mul(x, y)), " + reciprocal + ")");
    EXPECT_EQ(spelt(ratio(l.x, r) * ratio(l.y, l.z)).find("max"), std::string::npos)
        << "the second is over another length";
    EXPECT_EQ(spelt(ratio(l.x, l.z) * ratio(l.y, l.z)), "mul(ratio(x, z), ratio(y, z))")
        << "z is no length";
}

}  // namespace
}  // namespace passes
