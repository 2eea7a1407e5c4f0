// SPDX-License-Identifier: MIT
// Each identity, and what looks like one but is none.
#include "passes/simplify.h"

#include <gtest/gtest.h>

#include "passes/rule.h"

namespace passes {
namespace {

std::string simple(Expr expression) { return rewritten(simplify, expression); }

TEST(Simplify, drops_neutral_operands) {
    Leaves l;
    EXPECT_EQ(simple(l.x + 0.0), "x");
    EXPECT_EQ(simple(0.0 + l.x), "x");
    EXPECT_EQ(simple(l.x - 0.0), "x");
    EXPECT_EQ(simple(l.x * 1.0), "x");
    EXPECT_EQ(simple(1.0 * l.x), "x");
    EXPECT_EQ(simple(l.x / 1.0), "x");
}

TEST(Simplify, joins_signs_with_sums) {
    Leaves l;
    EXPECT_EQ(simple(l.x + -l.y), "sub(x, y)");
    EXPECT_EQ(simple(-l.x + l.y), "sub(y, x)");
    EXPECT_EQ(simple(l.x - -l.y), "add(x, y)");
    EXPECT_EQ(simple(0.0 - l.x), "neg(x)");
}

TEST(Simplify, turns_factors_of_minus_one_into_signs) {
    Leaves l;
    EXPECT_EQ(simple(l.x * -1.0), "neg(x)");
    EXPECT_EQ(simple(-1.0 * l.x), "neg(x)");
    EXPECT_EQ(simple(l.x / -1.0), "neg(x)");
    EXPECT_EQ(simple(-l.x * -l.y), "mul(x, y)");
    EXPECT_EQ(simple(-l.x / -l.y), "div(x, y)");
    EXPECT_EQ(simple(-(l.x - l.y)), "sub(y, x)");
}

TEST(Simplify, drops_signs_that_do_not_matter) {
    Leaves l;
    EXPECT_EQ(simple(-(-l.x)), "x");
    EXPECT_EQ(simple(abs(-l.x)), "abs(x)");
    EXPECT_EQ(simple(abs(abs(l.x))), "abs(x)");
}

TEST(Simplify, takes_signs_out_of_odd_functions_and_drops_them_in_even_ones) {
    Leaves l;
    for (const Op op : {Op::sin, Op::tan, Op::asin, Op::atan, Op::sinh, Op::tanh, Op::cbrt}) {
        const std::string name(graph::facts(op).name);
        EXPECT_EQ(simple(apply(op, -l.x)), "neg(" + name + "(x))");
    }
    EXPECT_EQ(simple(cos(-l.x)), "cos(x)");
    EXPECT_EQ(simple(apply(Op::cosh, abs(l.x))), "cosh(x)");
    EXPECT_EQ(simple(hypot(-l.x, abs(l.y))), "hypot(x, y)");
    EXPECT_EQ(simple(acos(-l.x)), "acos(neg(x))");
    EXPECT_EQ(simple(floor(-l.x)), "floor(neg(x))");
}

TEST(Simplify, knows_what_is_never_negative) {
    Leaves l;
    EXPECT_EQ(simple(abs(exp(l.x))), "exp(x)");
    EXPECT_EQ(simple(abs(l.x * l.x)), "mul(x, x)");
    EXPECT_EQ(simple(abs(l.x) * abs(l.x)), "mul(x, x)");
    EXPECT_EQ(simple(abs(l.x * l.y)), "abs(mul(x, y))");
}

TEST(Simplify, rounds_once) {
    Leaves l;
    EXPECT_EQ(simple(floor(apply(Op::ceil, l.x))), "ceil(x)");
    EXPECT_EQ(simple(sign(sign(l.x))), "sign(x)");
    EXPECT_EQ(simple(sign(floor(l.x))), "sign(floor(x))");
}

TEST(Simplify, drops_minima_and_maxima_of_equals) {
    Leaves l;
    EXPECT_EQ(simple(min(l.x, l.x)), "x");
    EXPECT_EQ(simple(max(l.x, l.x)), "x");
}

TEST(Simplify, sees_what_becomes_simple_below) {
    Leaves l;
    EXPECT_EQ(simple(-(-(l.x + 0.0)) * (l.y * 1.0)), "mul(x, y)");
}

TEST(Simplify, keeps_products_with_zero) {
    Leaves l;
    EXPECT_EQ(simple(0.0 * log(l.x)), "mul(0, log(x))");
    EXPECT_EQ(simple(log(l.x) * 0.0), "mul(log(x), 0)");
}

TEST(Simplify, keeps_what_may_be_undefined) {
    Leaves l;
    EXPECT_EQ(simple(l.x - l.x), "sub(x, x)") << "an infinity less itself";
    EXPECT_EQ(simple(l.x / l.x), "div(x, x)");
    EXPECT_EQ(simple(0.0 / l.x), "div(0, x)");
    EXPECT_EQ(simple(select_less(log(l.x), l.y, l.z, l.z)), "select_less(log(x), y, z, z)");
    EXPECT_EQ(simple(-l.x * l.y), "mul(neg(x), y)");
}

}  // namespace
}  // namespace passes
