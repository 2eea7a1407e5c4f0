// SPDX-License-Identifier: MIT
// The derivative of every operator of graph/operators.def against differences of its values. A new
// operator is tested without an edit here, on arguments between -2 and 2.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

#include "eval/random_expression.h"
#include "eval/tape.h"
#include "passes/differentiate.h"
#include "passes/pipeline.h"
#include "passes/rule.h"

namespace passes {
namespace {

using Point = std::array<double, graph::max_arity>;

/// Where an operator is smooth all around; all of [-2, 2] unless it stands here.
bool is_smooth_around(Op op, const Point& a) {
    static const std::map<Op, std::function<bool(const Point&)>> conditions{
        {Op::div, [](const Point& p) { return std::abs(p[1]) > 0.3; }},
        {Op::pow, [](const Point& p) { return p[0] > 0.2; }},
        {Op::sqrt, [](const Point& p) { return p[0] > 0.2; }},
        {Op::cbrt, [](const Point& p) { return std::abs(p[0]) > 0.2; }},
        {Op::hypot, [](const Point& p) { return std::hypot(p[0], p[1]) > 0.2; }},
        {Op::hypot3, [](const Point& p) { return std::hypot(p[0], p[1], p[2]) > 0.2; }},
        {Op::tan, [](const Point& p) { return std::abs(std::cos(p[0])) > 0.3; }},
        {Op::asin, [](const Point& p) { return std::abs(p[0]) < 0.8; }},
        {Op::acos, [](const Point& p) { return std::abs(p[0]) < 0.8; }},
        {Op::atan2, [](const Point& p) { return std::abs(p[0]) > 0.2; }},
        {Op::log, [](const Point& p) { return p[0] > 0.2; }},
        {Op::abs, [](const Point& p) { return std::abs(p[0]) > 0.1; }},
        {Op::sign, [](const Point& p) { return std::abs(p[0]) > 0.1; }},
        {Op::floor, [](const Point& p) { return std::abs(p[0] - std::round(p[0])) > 0.1; }},
        {Op::ceil, [](const Point& p) { return std::abs(p[0] - std::round(p[0])) > 0.1; }},
        {Op::min, [](const Point& p) { return std::abs(p[0] - p[1]) > 0.2; }},
        {Op::max, [](const Point& p) { return std::abs(p[0] - p[1]) > 0.2; }},
        {Op::ratio, [](const Point& p) { return std::abs(p[0]) < p[1] - 0.2; }},
        {Op::select_less, [](const Point& p) { return std::abs(p[0] - p[1]) > 0.2; }},
    };
    const auto condition = conditions.find(op);
    return condition == conditions.end() || condition->second(a);
}

/// The derivative at 0 of a function that is smooth around it, by central differences extrapolated
/// to a width of 0 (Ridders).
double by_differences(const std::function<double(double)>& f) {
    constexpr int size = 6;
    std::array<double, size> row{}, previous{};
    double h = 0.05;
    for (int i = 0; i < size; ++i, h /= 2) {
        row[0] = (f(h) - f(-h)) / (2 * h);
        double power = 4;
        for (int k = 1; k <= i; ++k, power *= 4) {
            const auto n = static_cast<std::size_t>(k);
            row[n] = (power * row[n - 1] - previous[n - 1]) / (power - 1);
        }
        previous = row;
    }
    return previous[size - 1];
}

Point random_place(Op op, eval::Random& random) {
    std::uniform_real_distribution<double> number(-2, 2);
    Point at{};
    do {
        for (double& a : at) a = number(random);
    } while (!is_smooth_around(op, at));
    return at;
}

/// The operator on arguments of which those in the mask move along x, each at its own speed, and
/// the others are constants; where x is 0 they are at the place.
Expr moving(Leaves& l, Op op, const Point& at, const Point& speed, unsigned mask) {
    std::vector<graph::NodeId> arguments;
    for (std::size_t i = 0; i < static_cast<std::size_t>(graph::facts(op).arity); ++i) {
        Expr argument = l.number(at[i]);
        if ((mask >> i & 1U) != 0) argument = argument + speed[i] * l.x;
        arguments.push_back(argument.id);
    }
    return {l.graph, l.graph.apply(op, arguments)};
}

class Derivatives : public testing::TestWithParam<Op> {};

TEST_P(Derivatives, agree_with_differences_up_to_the_second) {
    constexpr unsigned seed = 271828;
    const Op op = GetParam();
    eval::Random random(seed);
    std::uniform_real_distribution<double> number(0.3, 1);
    const unsigned masks = 1U << graph::facts(op).arity;
    for (int trial = 0; trial < 20; ++trial) {
        const Point at = random_place(op, random);
        Point speed{};
        for (double& s : speed) s = random() % 2 == 0 ? number(random) : -number(random);
        for (unsigned mask = 1; mask < masks; ++mask) {
            Leaves l;
            graph::NodeId f = moving(l, op, at, speed, mask).id;
            for (int order = 1; order <= 2; ++order) {
                const graph::NodeId slope =
                    run(l.graph, std::array{differentiate(l.graph, f, graph::variable_x)})[0];
                const double expected = by_differences([&](double x) {
                    return eval::evaluate(l.graph, f, {x, 0, 0});
                });
                EXPECT_NEAR(eval::evaluate(l.graph, slope, {0, 0, 0}), expected,
                            2e-8 * (1 + std::abs(expected)))
                    << "order " << order << ", seed " << seed << ", at "
                    << ::testing::PrintToString(at) << " moving " << mask << ": "
                    << in_one_line(l.graph, f);
                f = slope;
            }
        }
    }
}

std::vector<Op> all_operators() {
    std::vector<Op> list;
    graph::for_each_operator([&](Op op) { list.push_back(op); });
    return list;
}

INSTANTIATE_TEST_SUITE_P(All, Derivatives, testing::ValuesIn(all_operators()),
                         [](const auto& info) {
                             return std::string(graph::facts(info.param).name);
                         });

}  // namespace
}  // namespace passes
