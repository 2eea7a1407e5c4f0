// SPDX-License-Identifier: MIT
// All passes together keep what an expression means.
#include "passes/pipeline.h"

#include <gtest/gtest.h>

#include <set>

#include "eval/random_expression.h"
#include "eval/tape.h"
#include "field/primitives.h"
#include "graph/print.h"
#include "passes/rule.h"

namespace passes {
namespace {

using numeric::Interval;

TEST(Pipeline, names_each_pass_once_except_for_folding) {
    std::set<std::string_view> names;
    for (const Pass& pass : pipeline()) EXPECT_TRUE(names.insert(pass.name).second) << pass.name;
}

std::string passed(Expr expression) {
    graph::Graph& graph = *expression.graph;
    return in_one_line(graph, run(graph, std::array{expression.id})[0]);
}

TEST(Pipeline, makes_a_length_of_typed_out_powers) {
    Leaves l;
    const auto squared = [&](Expr a) { return pow(a, l.number(2)); };
    const Expr length = pow(squared(l.x) + squared(l.y) + squared(l.z), l.number(0.5));
    EXPECT_EQ(passed(length), "hypot3(x, y, z)");
    EXPECT_EQ(passed(sqrt(squared(l.x) + squared(l.y * 1.0) + 0.0)), "hypot(x, y)");
    EXPECT_EQ(passed(sqrt(squared(l.x - 0.0) + squared(-(-l.y)))), "hypot(x, y)");
}

TEST(Pipeline, folds_what_other_passes_bring_together) {
    Leaves l;
    EXPECT_EQ(passed(pow(l.number(3), l.number(2)) * l.x), "mul(9, x)");
    EXPECT_EQ(passed(l.x * (l.number(3) - 2.0)), "x");
}

/// Both intervals hold the exact value of what should be the same expression, so they overlap; and
/// neither is undefined everywhere where the other is proven to be defined.
bool may_be_equal(const Interval& a, const Interval& b) {
    if (a.is_empty() || b.is_empty())
        return (a.is_empty() || a.partial) && (b.is_empty() || b.partial);
    return a.lo <= b.hi && b.lo <= a.hi;
}

TEST(Pipeline, keeps_the_value_of_random_expressions) {
    constexpr unsigned seed = 4711;
    eval::Random random(seed);
    int changed = 0, sharp = 0;
    for (int i = 0; i < 10000; ++i) {
        auto [graph, root] = eval::random_expression(random, 1 + static_cast<int>(random() % 16));
        const graph::NodeId after = run(graph, std::array{root})[0];
        changed += after != root;
        for (int k = 0; k < 8; ++k) {
            const std::array<double, 4> at{
                eval::ordinary_number(random), eval::ordinary_number(random),
                eval::ordinary_number(random), eval::ordinary_number(random)};
            const std::array<Interval, 3> point{at[0], at[1], at[2]};
            const std::array parameters{0.0, at[3]};
            const Interval a = eval::enclose(graph, root, point, parameters);
            const Interval b = eval::enclose(graph, after, point, parameters);
            sharp += !a.is_empty() && !b.is_empty() && a.hi - a.lo < 1e-9 && b.hi - b.lo < 1e-9;
            ASSERT_TRUE(may_be_equal(a, b))
                << "seed " << seed << ", expression " << i << " at " << ::testing::PrintToString(at)
                << ": [" << a.lo << ", " << a.hi << "] became [" << b.lo << ", " << b.hi << "]\n"
                << print(graph, std::array{root}) << "became\n"
                << print(graph, std::array{after});
            // Not so where it overflows or has been at a pole: then there may be no exact value.
            const double value = eval::evaluate(graph, after, {at[0], at[1], at[2]}, parameters);
            ASSERT_TRUE(!std::isfinite(value) || b.partial || b.contains(value))
                << "seed " << seed << ", expression " << i << " at "
                << ::testing::PrintToString(at);
        }
    }
    EXPECT_GT(changed, 2000);
    EXPECT_GT(sharp, 20000) << "else the test says nothing";
}

TEST(Pipeline, is_the_same_for_a_field_and_its_expressions) {
    field::Field f;
    const field::Primitive* box = field::find_primitive("box");
    ASSERT_NE(box, nullptr);
    const std::array sides{f.graph.constant(1), f.graph.constant(2), f.graph.constant(3)};
    f.root = box->build(f, sides);
    const graph::NodeId value = std::get<field::Formula>(f[f.root]).value;
    const graph::NodeId expected = run(f.graph, std::array{value})[0];
    run(f);
    EXPECT_EQ(std::get<field::Formula>(f[f.root]).value, expected);
}

TEST(Pipeline, changes_nothing_the_second_time) {
    constexpr unsigned seed = 4712;
    eval::Random random(seed);
    int unstable = 0;
    for (int i = 0; i < 1000; ++i) {
        auto [graph, root] = eval::random_expression(random, 12);
        const graph::NodeId once = run(graph, std::array{root})[0];
        unstable += run(graph, std::array{once})[0] != once;
    }
    EXPECT_LE(unstable, 20) << "seed " << seed << ": the passes leave much work undone";
}

TEST(Pipeline, folds_an_exponent_that_is_multiplied_out_then) {
    Leaves l;
    const Expr power = pow(l.x + l.y, l.number(8) - 1.0);
    const auto result = run(l.graph, std::array{power.id});
    EXPECT_EQ(in_one_line(l.graph, result[0]).find("pow"), std::string::npos);
}

}  // namespace
}  // namespace passes
