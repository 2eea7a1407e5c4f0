// SPDX-License-Identifier: MIT
#include "eval/random_expression.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace eval {
namespace {

template <class T, std::size_t size>
T pick(const std::array<T, size>& list, Random& random) {
    return list[random() % size];
}

}  // namespace

double ordinary_number(Random& random) {
    const double number = std::uniform_real_distribution<double>(-4, 4)(random);
    return random() % 4 == 0 ? std::round(number) : number;
}

double awkward_number(Random& random) {
    using limits = std::numeric_limits<double>;
    static constexpr std::array special{0.0,
                                        -0.0,
                                        limits::denorm_min(),
                                        -limits::denorm_min(),
                                        limits::min(),
                                        1e-300,
                                        -1e-200,
                                        0.5,
                                        1.0,
                                        -1.0,
                                        1e15,
                                        -1e22,
                                        1e300,
                                        limits::max(),
                                        limits::lowest(),
                                        limits::infinity(),
                                        -limits::infinity()};
    const double half_pi = std::acos(0.0);
    switch (random() % 6) {
        case 0:
            return pick(special, random);
        case 1:
            return half_pi * std::round(10 * ordinary_number(random));
        case 2:
            return std::ldexp(ordinary_number(random), static_cast<int>(random() % 120) - 60);
        case 3:
            return std::round(3 * ordinary_number(random));
        default:
            return ordinary_number(random);
    }
}

RandomExpression random_expression(Random& random, int size, int variables) {
    using graph::NodeId;
    using graph::Op;
    RandomExpression result;
    graph::Graph& g = result.graph;
    const NodeId fourth =
        variables > 3 ? g.variable(g.new_variable("w")) : g.parameter(g.new_parameter("p"));
    std::vector<NodeId> nodes{g.variable(graph::variable_x),       g.variable(graph::variable_y),
                              g.variable(graph::variable_z),       fourth,
                              g.constant(ordinary_number(random)), g.constant(2)};
    const auto any = [&] { return nodes[random() % nodes.size()]; };
    for (int i = 0; i < size; ++i) {
        const auto op = static_cast<Op>(3 + random() % (graph::operator_count - 3));
        if (op == Op::ratio) {
            const NodeId a = any();
            nodes.push_back(g.apply(op, a, g.apply(Op::hypot, a, any())));
            continue;
        }
        std::vector<NodeId> arguments;
        for (int k = 0; k < graph::facts(op).arity; ++k) arguments.push_back(any());
        nodes.push_back(g.apply(op, arguments));
    }
    result.root = nodes.back();
    return result;
}

}  // namespace eval
