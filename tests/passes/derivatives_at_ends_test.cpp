// SPDX-License-Identifier: MIT
// Symbolic derivatives close to where an operator's domain ends, where it bends or where it jumps,
// against differences of five points with 113 bits. Both are good to 1e-10 of the derivative there.
#include <gtest/gtest.h>

#include <numbers>

#include "eval/random_expression.h"
#include "eval/tape.h"
#include "eval/wide.h"
#include "passes/differentiate.h"
#include "passes/rule.h"

namespace passes {
namespace {

using eval::Quad;

constexpr std::array ends{-2.0, -1.0, 0.0, 0.5, 1.0, std::numbers::pi / 2, 2.0};

/// The operator on x, y, z and one state variable, as far as it has arguments.
struct Operator {
    graph::Graph graph;
    std::vector<graph::NodeId> arguments;
    std::vector<Seed> seeds;
    graph::NodeId value{};

    Operator(Op op, const std::array<double, 4>& speed) {
        graph.new_variable("w");
        for (std::uint32_t i = 0; i < graph::arity(op); ++i) {
            const auto variable = static_cast<graph::VariableId>(i);
            arguments.push_back(graph.variable(variable));
            seeds.push_back({variable, graph.constant(speed[i])});
        }
        value = graph.apply(op, arguments);
    }
    Quad at(graph::NodeId node, const std::array<Quad, 4>& point) const {
        return eval::values_by_type<Quad>(graph, node, point, {}).back();
    }
};

class DerivativesAtEnds : public testing::TestWithParam<Op> {};

TEST_P(DerivativesAtEnds, agree_with_differences) {
    constexpr unsigned seed = 161803;
    const Op op = GetParam();
    eval::Random random(seed);
    std::uniform_real_distribution<double> number(0.5, 1);
    const auto either_sign = [&] { return random() % 2 == 0 ? number(random) : -number(random); };
    int checked = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const double distance = std::pow(10.0, -2.0 * static_cast<double>(random() % 4));
        const double h = distance * 1e-7;
        std::array<double, 4> end{}, speed{};
        std::array<Quad, 4> point;
        for (std::size_t i = 0; i < 4; ++i) {
            end[i] = random() % 3 == 0 && i > 0 ? end[i - 1] : ends[random() % ends.size()];
            speed[i] = either_sign();
            point[i] = Quad(end[i]) + Quad(distance * either_sign());
        }
        if (op == Op::ratio && !(abs(point[0]).number < point[1].number)) continue;
        Operator f(op, speed);
        const auto moved = [&](double s) {
            std::array<Quad, 4> p = point;
            for (std::size_t i = 0; i < 4; ++i) p[i] = p[i] + Quad(s) * Quad(speed[i]);
            return f.at(f.value, p);
        };
        const Quad expected =
            (8.0 * (moved(h) - moved(-h)) - (moved(2 * h) - moved(-2 * h))) / Quad(12 * h);
        if (!expected.is_finite()) continue;
        const graph::NodeId slope = differentiate(f.graph, std::array{f.value}, f.seeds)[0];
        const Quad found = f.at(slope, point);
        ++checked;
        const double scale = std::max(std::abs(static_cast<double>(expected)), distance);
        ASSERT_LE(std::abs(static_cast<double>(found - expected)), 1e-10 * scale)
            << graph::facts(op).name << " at " << static_cast<double>(point[0]) << ", "
            << static_cast<double>(point[1]) << ", " << static_cast<double>(point[2]) << ": "
            << static_cast<double>(found) << " instead of " << static_cast<double>(expected)
            << ", seed " << seed << ", trial " << trial;
    }
    EXPECT_GT(checked, 400);
}

std::vector<Op> all_operators() {
    std::vector<Op> list;
    graph::for_each_operator([&](Op op) { list.push_back(op); });
    return list;
}
INSTANTIATE_TEST_SUITE_P(All, DerivativesAtEnds, testing::ValuesIn(all_operators()),
                         [](const auto& info) {
                             return std::string(graph::facts(info.param).name);
                         });

/// The derivative by x over a small box around the origin.
numeric::Interval slope_around_0(Expr f) {
    const graph::NodeId slope = differentiate(*f.graph, f.id, graph::variable_x);
    const numeric::Interval small(-0.01, 0.01);
    return eval::enclose(*f.graph, slope, {small, small, small});
}

TEST(Kinks, say_so_in_the_enclosure_of_the_derivative) {
    Leaves l;
    for (const Expr kink : {abs(l.x), min(l.x, 2.0 * l.x), max(l.x, l.y), hypot(l.x, l.y),
                            hypot(l.x, l.y, l.z), select_less(l.x, l.y, l.x, 2.0 * l.x)}) {
        const numeric::Interval slope = slope_around_0(kink);
        EXPECT_TRUE(slope.jumps || slope.partial) << in_one_line(l.graph, kink.id);
    }
    for (const Expr smooth : {sin(l.x), l.x * l.y, abs(l.x + 1.0), hypot(l.x, l.y + 1.0)}) {
        const numeric::Interval slope = slope_around_0(smooth);
        EXPECT_FALSE(slope.jumps || slope.partial) << in_one_line(l.graph, smooth.id);
    }
}

TEST(Jumps, say_so_in_the_enclosure_of_the_value) {
    Leaves l;
    const numeric::Interval small(-0.01, 0.01);
    for (const Expr jump : {floor(l.x), apply(Op::ceil, l.x), sign(l.x)}) {
        EXPECT_TRUE(eval::enclose(l.graph, jump.id, {small, small, small}).jumps)
            << in_one_line(l.graph, jump.id);
    }
}

}  // namespace
}  // namespace passes
