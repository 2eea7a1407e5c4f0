// SPDX-License-Identifier: MIT
// Lengths in disguise.
#include "passes/recognise_hypot.h"

#include <gtest/gtest.h>

#include "passes/rule.h"

namespace passes {
namespace {

std::string recognised(Expr expression) { return rewritten(recognise_hypot, expression); }

TEST(RecogniseHypot, finds_lengths_of_two_and_three) {
    Leaves l;
    EXPECT_EQ(recognised(sqrt(l.x * l.x + l.y * l.y)), "hypot(x, y)");
    EXPECT_EQ(recognised(sqrt(l.x * l.x + l.y * l.y + l.z * l.z)), "hypot3(x, y, z)");
    EXPECT_EQ(recognised(sqrt(l.x * l.x + (l.y * l.y + l.z * l.z))), "hypot3(x, y, z)");
}

TEST(RecogniseHypot, takes_the_root_of_a_square_for_an_absolute_value) {
    Leaves l;
    EXPECT_EQ(recognised(sqrt(l.x * l.x)), "abs(x)");
}

TEST(RecogniseHypot, finds_lengths_of_expressions) {
    Leaves l;
    const Expr a = l.x - 1.0;
    EXPECT_EQ(recognised(sqrt(a * a + l.y * l.y)), "hypot(sub(x, 1), y)");
}

TEST(RecogniseHypot, leaves_other_roots_alone) {
    Leaves l;
    EXPECT_EQ(recognised(sqrt(l.x * l.y)), "sqrt(mul(x, y))");
    EXPECT_EQ(recognised(sqrt(l.x * l.x - l.y * l.y)), "sqrt(sub(mul(x, x), mul(y, y)))");
    EXPECT_EQ(recognised(sqrt(l.x * l.x + l.y)), "sqrt(add(mul(x, x), y))");
    const Expr four = (l.x * l.x + l.y * l.y) + (l.z * l.z + l.t * l.t);
    EXPECT_EQ(recognised(sqrt(four)),
              "sqrt(add(add(mul(x, x), mul(y, y)), add(mul(z, z), mul(t, t))))");
}

}  // namespace
}  // namespace passes
