// SPDX-License-Identifier: MIT
// Common factors come out where that saves operations, and only there.
#include "passes/horner.h"

#include <gtest/gtest.h>

#include "passes/operation_count.h"
#include "passes/pipeline.h"
#include "passes/rule.h"

namespace passes {
namespace {

Expr power(Leaves& l, Expr base, int n) { return pow(base, l.number(n)); }

/// What becomes of the expressions in all passes up to the last.
std::vector<graph::NodeId> evaluated(graph::Graph& graph, std::vector<graph::NodeId> roots) {
    return run(graph, run(graph, roots), Stage::evaluation);
}
std::string evaluated(Expr f) {
    return in_one_line(*f.graph, evaluated(*f.graph, std::vector{f.id})[0]);
}

TEST(Horner, nests_a_polynomial_in_one_variable) {
    Leaves l;
    const Expr f = 4.0 * power(l, l.x, 3) - 3.0 * power(l, l.x, 2) + 2.0 * l.x - 5.0;
    EXPECT_EQ(evaluated(f), "sub(mul(x, add(2, mul(x, sub(mul(4, x), 3)))), 5)");
}

TEST(Horner, keeps_the_powers_that_it_needs) {
    Leaves l;
    const Expr f = 32.0 * power(l, l.x, 6) - 48.0 * power(l, l.x, 4) + 18.0 * power(l, l.x, 2);
    const std::vector<graph::NodeId> after = evaluated(l.graph, {f.id});
    EXPECT_EQ(count_operations(l.graph, after).at_points, 6U) << in_one_line(l.graph, after[0]);
}

TEST(Horner, takes_out_what_several_products_share) {
    Leaves l;
    EXPECT_EQ(evaluated(l.x * l.y + l.x * l.z), "mul(x, add(y, z))");
    EXPECT_EQ(evaluated(3.0 * l.x - 3.0 * l.y * l.z), "mul(3, sub(x, mul(y, z)))");
    EXPECT_EQ(evaluated(-(l.x * l.y) - l.x * l.z + l.t), "sub(t, mul(x, add(y, z)))");
}

TEST(Horner, takes_long_sums_in_groups) {
    Leaves l;
    Expr f = l.x * sin(l.y);
    for (int k = 2; k <= 100; ++k) f = f + l.x * sin(static_cast<double>(k) * l.y);
    const std::vector<graph::NodeId> after = evaluated(l.graph, {f.id});
    const auto operations = [&](graph::NodeId id) {
        return count_operations(l.graph, std::array{id}).at_points;
    };
    // Two products with x in place of a hundred.
    EXPECT_EQ(operations(after[0]), operations(f.id) - 98);
}

TEST(Horner, leaves_alone_what_is_shared_otherwise) {
    Leaves l;
    const Expr a = l.x * l.y, b = l.x * l.z;
    const std::vector roots{(a + b).id, sin(a).id, sin(b).id};
    const std::vector<graph::NodeId> after = evaluated(l.graph, roots);
    EXPECT_EQ(in_one_line(l.graph, after[0]), "add(mul(x, y), mul(x, z))");
}

TEST(Horner, finds_nothing_in_sums_of_different_things) {
    Leaves l;
    EXPECT_EQ(transformed(horner, l.x * l.y + l.z), "add(mul(x, y), z)");
    EXPECT_EQ(transformed(horner, l.x - (l.y - l.z)), "sub(x, sub(y, z))");
}

TEST(Horner, goes_through_sums_within_sums) {
    Leaves l;
    const Expr inner = l.x * l.y + l.x * l.z;
    EXPECT_EQ(evaluated(inner * l.t + sin(l.y) * inner), "mul(mul(x, add(y, z)), add(t, sin(y)))");
}

}  // namespace
}  // namespace passes
