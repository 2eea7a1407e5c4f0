// SPDX-License-Identifier: MIT
// The running error as an expression: above every error that operators may make which keep their
// promises, and close to what intervals say of the same point.
#include "analysis/running_error.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "analysis/erring_value.h"
#include "analysis/rounding_error.h"
#include "eval/random_expression.h"
#include "eval/tape.h"
#include "graph/build.h"
#include "graph/print.h"

namespace analysis {
namespace {

constexpr unsigned seed = 20261123;

double value_of(const graph::Graph& graph, graph::NodeId root, const std::vector<double>& at) {
    const eval::Tape tape = eval::make_tape(graph, std::array{root});
    std::vector<double> registers;
    double value = 0;
    eval::evaluate<double>(tape, at, {}, std::span(&value, 1), registers);
    return value;
}

std::optional<graph::NodeId> running_error(graph::Graph& graph, graph::NodeId root, double position,
                                           double part = 1) {
    return running_errors(graph, std::array{root}, graph.constant(position), part)[0];
}

TEST(RunningError, is_above_that_of_operators_that_err_as_much_as_they_may) {
    Random random(seed);
    int bounded = 0, tight = 0;
    double closest = 0;
    for (int i = 0; i < 3000; ++i) {
        eval::RandomExpression e = eval::random_expression(random, 2 + i % 10, 4);
        const eval::Tape tape = eval::make_tape(e.graph, std::array{e.root});
        const auto error = running_error(e.graph, e.root, 0);
        if (!error) continue;
        RoundingErrors by_intervals(tape, {});
        for (int k = 0; k < 20; ++k) {
            std::vector<double> at(4);
            std::vector<Rounded> point(4);
            for (std::size_t v = 0; v < 4; ++v) {
                at[v] = rounded(std::uniform_real_distribution(-4.0, 4.0)(random));
                point[v].exact = at[v];
            }
            const Rounded known = by_intervals(point)[0];
            const double found = erring_value(tape, at, random);
            if (!std::isfinite(known.error) || !std::isfinite(found)) continue;
            const double bound = value_of(e.graph, *error, at);
            const double off = std::max(known.exact.lo - found, found - known.exact.hi);
            // Errors of a hundredth are none to the first order.
            if (known.error > 0.01 * (1 + magnitude(known.exact))) continue;
            ++bounded;
            // Numbers below the least normal one may become 0, which only intervals count.
            EXPECT_LE(off, 1.05 * bound + 1e-30) << "seed " << seed << "\n"
                                                 << graph::print(e.graph, std::array{e.root});
            if (bound > 0) closest = std::max(closest, off / bound);
            if (bound <= 2 * known.error + 1e-30) ++tight;
        }
    }
    fmt::print("seed {}: {} values, closest {:.3f}, {} within twice that of intervals\n", seed,
               bounded, closest, tight);
    EXPECT_GT(bounded, 5000);
    EXPECT_GT(closest, 0.5);
    EXPECT_GT(tight, bounded * 3 / 4);
}

TEST(RunningError, vanishes_with_the_factors_that_err) {
    graph::Graph graph;
    const graph::Expr x(graph, graph.variable(graph::variable_x));
    const graph::Expr q = x * x - 1.0, f = q * q;
    const auto error = running_error(graph, f.id, 0);
    ASSERT_TRUE(error);
    EXPECT_GT(value_of(graph, *error, {2, 0, 0}), 1e-6);
    EXPECT_LT(value_of(graph, *error, {1.001, 0, 0}), 2e-9);
}

TEST(RunningError, counts_the_rounding_of_the_point) {
    graph::Graph graph;
    const graph::Expr x(graph, graph.variable(graph::variable_x));
    const graph::Expr y(graph, graph.variable(graph::variable_y));
    const graph::Expr q = x - y;
    const auto error = running_error(graph, (q * q).id, 1e-3);
    ASSERT_TRUE(error);
    // Both differences are off by 2e-3, also where they vanish.
    EXPECT_NEAR(value_of(graph, *error, {1, 1, 0}), 4e-6, 1e-9);
    EXPECT_NEAR(value_of(graph, *error, {2, 1, 0}), 4e-3 + 4e-6, 1e-6);
}

TEST(RunningError, is_less_by_more_exact_operators) {
    graph::Graph graph;
    const graph::Expr x(graph, graph.variable(graph::variable_x));
    const graph::Expr f = sin(x) * exp(x) - 0.7;
    const auto single = running_error(graph, f.id, 0);
    const auto other = running_error(graph, f.id, 0, 1e-6);
    ASSERT_TRUE(single && other);
    const double most = value_of(graph, *single, {1, 0, 0});
    EXPECT_GT(most, 1e-7);
    EXPECT_NEAR(value_of(graph, *other, {1, 0, 0}), 1e-6 * most, 1e-8 * most);
}

TEST(RunningError, is_unknown_where_an_operator_is_steep_or_jumps) {
    graph::Graph graph;
    const graph::Expr x(graph, graph.variable(graph::variable_x));
    for (const graph::Expr f : {sqrt(x), floor(x), x / (x - 1.0), acos(x), log(x)}) {
        EXPECT_FALSE(running_error(graph, f.id, 0)) << graph::print(graph, std::array{f.id});
    }
}

}  // namespace
}  // namespace analysis
