// SPDX-License-Identifier: MIT
// Many points at once against one after the other, and how fast both are.
#include "eval/batch.h"

#include <bit>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>

#include <gtest/gtest.h>

#include "eval/random_expression.h"

namespace eval {
namespace {

using graph::Op;

constexpr unsigned seed = 6174;

/// A list of numbers for each of x, y, z.
struct Points {
    std::array<std::vector<double>, 3> coordinates;

    std::array<std::span<const double>, 3> lists() const {
        return {coordinates[0], coordinates[1], coordinates[2]};
    }
    std::array<double, 3> operator[](std::size_t i) const {
        return {coordinates[0][i], coordinates[1][i], coordinates[2][i]};
    }
};

template <class Number>
Points points(std::size_t count, Random& random, Number number) {
    Points result;
    for (auto& list : result.coordinates) {
        list.resize(count);
        for (double& coordinate : list) coordinate = number(random);
    }
    return result;
}

bool same_bits(double a, double b) {
    return (a != a && b != b) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(Batch, is_bit_for_bit_what_single_points_give) {
    Random random(seed);
    for (int i = 0; i < 400; ++i) {
        const RandomExpression e = random_expression(random, 12);
        const graph::NodeId other = e.graph.size() > 9 ? static_cast<graph::NodeId>(9) : e.root;
        const Tape tape = make_tape(e.graph, std::array{e.root, other});
        const std::array parameters{0.0, ordinary_number(random)};
        std::vector<double> registers, scratch;
        load_parameters<double>(tape, parameters, registers);
        const std::size_t count = random() % (3 * block_size);
        const Points p = points(count, random, awkward_number);
        std::vector<double> first(count), second(count);
        evaluate_points(tape, registers, p.lists(), std::array<std::span<double>, 2>{first, second},
                        scratch);
        for (std::size_t k = 0; k < count; ++k) {
            std::array<double, 2> expected{};
            evaluate_loaded<double>(tape, p[k], expected, registers);
            ASSERT_TRUE(same_bits(first[k], expected[0]) && same_bits(second[k], expected[1]))
                << first[k] << ", " << second[k] << " instead of " << expected[0] << ", "
                << expected[1] << " at point " << k << ", expression " << i << ", seed " << seed;
        }
    }
}

/// A formula of 50 operations that go through the list of operators again and again.
RandomExpression fifty_operations(std::span<const Op> operators) {
    Random random(seed);
    RandomExpression result;
    graph::Graph& g = result.graph;
    std::vector<graph::NodeId> nodes{g.variable(graph::variable_x), g.variable(graph::variable_y),
                                     g.variable(graph::variable_z)};
    result.root = nodes[0];
    for (std::size_t i = 0; i < 50; ++i) {
        const Op op = operators[i % operators.size()];
        std::vector arguments{result.root};
        if (graph::facts(op).arity == 2) {
            arguments.push_back(random() % 4 == 0 ? g.constant(0.5 + 0.01 * static_cast<double>(i))
                                                  : nodes[random() % nodes.size()]);
        }
        result.root = g.apply(op, arguments);
        if (i % 3 == 0) nodes.push_back(result.root);
    }
    return result;
}

double seconds(const std::function<void()>& work) {
    double best = 1e9;
    for (int i = 0; i < 10; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
        best = std::min(best, time.count());
    }
    return best;
}

/// Evaluates in blocks and one by one; prints how many evaluations a second.
void race(const char* name, std::span<const Op> operators) {
    const RandomExpression e = fifty_operations(operators);
    const Tape tape = make_tape(e.graph, std::array{e.root});
    std::vector<double> registers, scratch;
    load_parameters<double>(tape, std::array{0.0}, registers);
    constexpr std::size_t count = 1 << 13;
    Random random(seed);
    const Points p = points(count, random, ordinary_number);
    std::vector<double> values(count), expected(count);
    const double in_blocks = seconds([&] {
        evaluate_points(tape, registers, p.lists(), std::array<std::span<double>, 1>{values},
                        scratch);
    });
    const double one_by_one = seconds([&] {
        for (std::size_t i = 0; i < count; ++i) {
            evaluate_loaded<double>(tape, p[i], std::span(&expected[i], 1), registers);
        }
    });
    for (std::size_t i = 0; i < count; ++i) {
        ASSERT_TRUE(same_bits(values[i], expected[i])) << "point " << i << ", seed " << seed;
    }
    std::printf("%s, 50 operations: %.1f million evaluations a second in blocks, %.1f one by one\n",
                name, count / in_blocks / 1e6, count / one_by_one / 1e6);
}

TEST(Batch, is_timed_on_arithmetic) {
    race("arithmetic", std::array{Op::mul, Op::add, Op::mul, Op::sub, Op::mul, Op::add, Op::abs,
                                  Op::min, Op::mul, Op::add, Op::mul, Op::max, Op::sub, Op::div});
}

TEST(Batch, is_timed_on_sines_and_exponentials) {
    race("one in six a sine or an exponential",
         std::array{Op::mul, Op::add, Op::sin, Op::sub, Op::mul, Op::add, Op::mul, Op::add, Op::mul,
                    Op::exp, Op::neg, Op::mul});
}

}  // namespace
}  // namespace eval
