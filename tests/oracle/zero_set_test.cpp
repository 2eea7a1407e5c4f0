// SPDX-License-Identifier: MIT
#include "oracle/zero_set.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "compile/compile.h"
#include "eval/random_expression.h"
#include "eval/tape.h"
#include "graph/print.h"
#include "oracle/traced.h"

namespace oracle {
namespace {

/// How many zero sets a sheet has, and how many guards in all.
std::pair<std::size_t, std::size_t> sizes(const std::string& formula) {
    compile::Formula understood = oracle::understood(formula);
    field::Field& field = understood.field;
    const auto sets = zero_sets(field.graph, std::get<field::Formula>(field[field.root]).value);
    std::size_t guards = 0;
    for (const ZeroSet& set : sets) guards += set.guards.size();
    return {sets.size(), guards};
}

using Sizes = std::pair<std::size_t, std::size_t>;

TEST(ZeroSet, looks_at_each_factor) {
    EXPECT_EQ(sizes("x*y*(z - 1) = 0"), Sizes(3, 0));
    EXPECT_EQ(sizes("x^2*exp(y) = 0"), Sizes(1, 0));
    EXPECT_EQ(sizes("x^2 + y^2 = 1"), Sizes(1, 0));
    // Where a root is undefined, the other factor does not count.
    EXPECT_EQ(sizes("x*sqrt(y) = 0"), Sizes(2, 1));
}

TEST(ZeroSet, leaves_the_zeros_of_denominators_out) {
    EXPECT_EQ(sizes("1/x = 0"), Sizes(0, 0));
    EXPECT_EQ(sizes("(x - 1)/(y*z) = 0"), Sizes(1, 2));
    EXPECT_EQ(sizes("1/x + 1/y = z"), Sizes(1, 2));
    EXPECT_EQ(sizes("x/x = 0"), Sizes(0, 0));
    EXPECT_EQ(sizes("tan(x) = 1"), Sizes(1, 1));
    EXPECT_EQ(sizes("x/3 = 1"), Sizes(1, 0));
}

TEST(ZeroSet, of_what_is_never_zero_is_empty) {
    EXPECT_EQ(sizes("exp(x + y) = 0"), Sizes(0, 0));
    EXPECT_EQ(sizes("cosh(x)/z^2 = 0"), Sizes(0, 0));
    EXPECT_EQ(sizes("5 = 0"), Sizes(0, 0));
}

/// At a random point only a zero of the expression is a zero of one of its sets.
TEST(ZeroSet, has_no_more_zeros_than_the_expression) {
    constexpr std::uint64_t seed = 41;
    SCOPED_TRACE("seed " + std::to_string(seed));
    eval::Random random(seed);
    const std::array<double, 2> parameters{0, 0.7};
    int zeros = 0;
    for (int i = 0; i < 20'000; ++i) {
        eval::RandomExpression expression =
            eval::random_expression(random, 1 + static_cast<int>(random() % 8));
        graph::Graph& graph = expression.graph;
        const auto sets = zero_sets(graph, expression.root);
        const auto place = [&] { return std::round(eval::ordinary_number(random)); };
        const glm::dvec3 point(place(), place(), place());
        const auto at = [&](graph::NodeId id) {
            return eval::evaluate(graph, id, point, parameters);
        };
        const double value = at(expression.root);
        bool any = false;
        for (const ZeroSet& set : sets) {
            const double zero = at(set.zero);
            bool drawn = set.below ? zero <= 0 : zero == 0;
            for (const graph::NodeId guard : set.guards) {
                drawn = drawn && at(guard) != 0 && !std::isnan(at(guard));
            }
            any = any || drawn;
        }
        zeros += value == 0;
        // An infinity is a pole, or the end of what double can show.
        if (std::isfinite(value) && any) {
            EXPECT_NEAR(value, 0, 1e-12) << graph::print(graph, std::array{expression.root});
        }
        if (value == 0 && !any) {
            // Found by rounding only: at once beside the point it is no zero any more, or exp and
            // its like have fallen below all numbers.
            bool close = false;
            for (const ZeroSet& set : sets) close = close || std::abs(at(set.zero)) < 1e-12;
            EXPECT_TRUE(close) << graph::print(graph, std::array{expression.root});
        }
    }
    EXPECT_GT(zeros, 500);
}

}  // namespace
}  // namespace oracle
