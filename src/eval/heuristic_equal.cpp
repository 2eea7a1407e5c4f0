// SPDX-License-Identifier: MIT
#include "eval/heuristic_equal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "eval/tape.h"

namespace eval {

bool heuristic_equal(const graph::Graph& graph, graph::NodeId a, graph::NodeId b) {
    if (a == b) return true;
    constexpr int points = 12;
    constexpr double tolerance = 1e-9;
    const Tape tape = make_tape(graph, std::array{a, b});
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> number(-2, 2);
    std::vector<double> variables(graph.variable_count()), parameters(graph.parameter_count());
    std::vector<double> scratch;
    int defined = 0;
    for (int i = 0; i < points; ++i) {
        for (double& it : variables) it = number(random);
        for (double& it : parameters) it = number(random);
        std::array<double, 2> value{};
        evaluate<double>(tape, variables, parameters, value, scratch);
        if (std::isnan(value[0]) && std::isnan(value[1])) continue;
        const double size = std::max(std::abs(value[0]), std::abs(value[1]));
        if (!(std::abs(value[0] - value[1]) <= tolerance * std::max(size, 1.0))) return false;
        ++defined;
    }
    return 2 * defined >= points;
}

}  // namespace eval
