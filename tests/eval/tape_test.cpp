// SPDX-License-Identifier: MIT
// Tapes against the recursion that they replace, and whole expressions on intervals.
#include "eval/tape.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "eval/operators.h"
#include "eval/random_expression.h"
#include "graph/build.h"

namespace eval {
namespace {

using graph::Expr;
using numeric::Interval;

constexpr unsigned seed = 1729;

/// Evaluates by the definition of a graph; `finite` turns false at an infinite or undefined value
/// on the way.
double recursion(const graph::Graph& graph, graph::NodeId id, std::span<const double> variables,
                 std::span<const double> parameters, bool& finite) {
    const graph::Node& node = graph[id];
    double value = node.value;
    if (node.op == graph::Op::variable) value = variables[node.symbol];
    if (node.op == graph::Op::parameter) value = parameters[node.symbol];
    if (!node.args().empty()) {
        std::vector<double> arguments;
        for (const graph::NodeId argument : node.args()) {
            arguments.push_back(recursion(graph, argument, variables, parameters, finite));
        }
        value = apply<double>(node.op, arguments);
    }
    finite = finite && std::isfinite(value);
    return value;
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

TEST(Tape, equals_direct_recursion) {
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        const RandomExpression e = random_expression(random, 12);
        const Tape tape = make_tape(e.graph, std::array{e.root});
        const std::array variables{ordinary_number(random), ordinary_number(random),
                                   ordinary_number(random)};
        const std::array parameters{0.0, ordinary_number(random)};
        std::vector<double> scratch;
        double value = 0;
        evaluate<double>(tape, variables, parameters, std::span(&value, 1), scratch);
        bool finite = true;
        const double expected = recursion(e.graph, e.root, variables, parameters, finite);
        ASSERT_TRUE(same(value, expected))
            << value << " instead of " << expected << ", expression " << i << ", seed " << seed;
    }
}

TEST(Tape, encloses_the_values_of_random_expressions) {
    Random random(seed + 1);
    int checked = 0;
    for (int i = 0; i < 3000; ++i) {
        const RandomExpression e = random_expression(random, 8);
        std::array<Interval, 3> box;
        for (Interval& side : box) {
            const double a = ordinary_number(random), b = ordinary_number(random);
            side = {std::min(a, b), std::max(a, b)};
        }
        const std::array parameters{0.0, ordinary_number(random)};
        const Interval result = enclose(e.graph, e.root, box, parameters);
        for (int k = 0; k < 20; ++k) {
            std::array<double, 3> p;
            for (std::size_t n = 0; n < 3; ++n) {
                p[n] = std::uniform_real_distribution<double>(box[n].lo, box[n].hi)(random);
            }
            bool finite = true;
            const double value = recursion(e.graph, e.root, p, parameters, finite);
            if (!finite) continue;  // behind a pole only `partial` counts
            ++checked;
            ASSERT_TRUE(result.contains(value))
                << value << " is not in [" << result.lo << ", " << result.hi << "], expression "
                << i << ", seed " << seed;
        }
        ASSERT_TRUE(result.is_empty() || result.lo <= result.hi);
    }
    EXPECT_GT(checked, 10000);
}

TEST(Tape, is_monotone_under_inclusion) {
    Random random(seed + 2);
    for (int i = 0; i < 3000; ++i) {
        const RandomExpression e = random_expression(random, 8);
        std::array<Interval, 3> outer, inner;
        for (std::size_t n = 0; n < 3; ++n) {
            std::array<double, 4> cuts;
            for (double& cut : cuts) cut = ordinary_number(random);
            std::ranges::sort(cuts);
            outer[n] = {cuts[0], cuts[3]};
            inner[n] = {cuts[1], cuts[2]};
        }
        const std::array parameters{0.0, ordinary_number(random)};
        const Interval large = enclose(e.graph, e.root, outer, parameters);
        const Interval small = enclose(e.graph, e.root, inner, parameters);
        if (small.is_empty()) continue;
        // Up to the rounding errors, which steep functions and poles magnify.
        const auto slack = [](double end) { return 1e-9 * std::abs(end) + 1e-12; };
        if (std::isfinite(large.lo)) {
            ASSERT_LE(large.lo - slack(large.lo), small.lo) << "expression " << i;
        }
        if (std::isfinite(large.hi)) {
            ASSERT_GE(large.hi + slack(large.hi), small.hi) << "expression " << i;
        }
        ASSERT_TRUE(large.partial || !small.partial) << "expression " << i << ", seed " << seed;
        ASSERT_TRUE(large.jumps || !small.jumps) << "expression " << i << ", seed " << seed;
    }
}

TEST(Tape, holds_only_what_its_roots_need) {
    graph::Graph g;
    const Expr x(g, g.variable(graph::variable_x)), y(g, g.variable(graph::variable_y));
    const Expr p(g, g.parameter(g.new_parameter("p")));
    const Expr unused = sin(y);
    const Expr shared = x * x;
    const Expr root = shared + (p + 1.0) * shared;
    (void)unused;
    const Tape tape = make_tape(g, std::array{root.id, shared.id});
    EXPECT_EQ(tape.variables.size(), 1u);
    EXPECT_EQ(tape.parameters.size(), 1u);
    EXPECT_EQ(tape.constants.size(), 1u);
    EXPECT_EQ(tape.instructions.size(), 4u);
    EXPECT_EQ(tape.independent, 1u) << "p + 1 is worked out once for all points";
}

TEST(Tape, uses_registers_again_whose_content_is_needed_no_more) {
    graph::Graph g;
    const Expr x(g, g.variable(graph::variable_x)), y(g, g.variable(graph::variable_y));
    Expr root = x;
    for (int i = 0; i < 100; ++i) root = sin(root * y);
    const Tape tape = make_tape(g, std::array{root.id});
    EXPECT_EQ(tape.instructions.size(), 200u);
    EXPECT_LE(tape.register_count, 3u);
}

TEST(Tape, keeps_every_root_until_the_end) {
    graph::Graph g;
    const Expr x(g, g.variable(graph::variable_x));
    const Expr first = x + 1.0, second = first * 2.0, third = second - x;
    const Tape tape = make_tape(g, std::array{x.id, first.id, third.id, second.id, first.id});
    std::array<double, 5> roots{};
    std::vector<double> scratch;
    evaluate<double>(tape, std::array{3.0}, std::array{0.0}, roots, scratch);
    EXPECT_EQ(roots, (std::array{3.0, 4.0, 5.0, 8.0, 4.0}));
}

TEST(Tape, keeps_loaded_parameters_for_many_points) {
    graph::Graph g;
    const Expr x(g, g.variable(graph::variable_x));
    const Expr p(g, g.parameter(g.new_parameter("p")));
    const Tape tape = make_tape(g, std::array{(x * exp(p)).id, p.id});
    std::vector<double> registers;
    load_parameters<double>(tape, std::array{0.0, 1.5}, registers);
    for (const double at : {1.0, -2.0, 0.25}) {
        std::array<double, 2> roots{};
        evaluate_loaded<double>(tape, std::array{at}, roots, registers);
        EXPECT_EQ(roots[0], at * std::exp(1.5));
        EXPECT_EQ(roots[1], 1.5);
    }
}

TEST(Tape, knows_that_a_product_with_itself_is_not_negative) {
    graph::Graph g;
    const Expr x(g, g.variable(graph::variable_x));
    const Interval result = enclose(g, (x * x).id, {Interval{-1, 2}, 0.0, 0.0});
    EXPECT_EQ(result.lo, 0);
    EXPECT_NEAR(result.hi, 4, 1e-14);
    EXPECT_FALSE(enclose(g, sqrt(x * x).id, {Interval{-1, 2}, 0.0, 0.0}).partial);
}

TEST(Tape, evaluates_leaves_as_roots) {
    graph::Graph g;
    EXPECT_EQ(evaluate(g, g.constant(3), {1, 2, 4}), 3);
    EXPECT_EQ(evaluate(g, g.variable(graph::variable_z), {1, 2, 4}), 4);
    EXPECT_EQ(evaluate(g, g.parameter(graph::parameter_t), {1, 2, 4}, std::array{0.5}), 0.5);
    EXPECT_EQ(evaluate(g, g.parameter(graph::parameter_t), {1, 2, 4}), 0);
}

}  // namespace
}  // namespace eval
