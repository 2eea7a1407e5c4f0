// SPDX-License-Identifier: MIT
#include "oracle/unroll.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "eval/tape.h"
#include "graph/substitute.h"

namespace oracle {
namespace {

/// Each turn doubles or triples the detail; finer than this an estimate does better than a proof.
constexpr double most_turns = 8;
constexpr std::size_t most_nodes = 3000;

/// By how much an interval is larger than the values of something that changes by no more than the
/// point, at a point where folds are close: the median over some places. Each fold of a chain of
/// folds makes it several times as large, and soon nothing can be proven.
double heuristic_excess(const graph::Graph& graph, graph::NodeId value,
                        std::span<const double> parameters) {
    constexpr double half = 1e-4;
    std::array<double, 15> excess{};
    for (std::size_t i = 0; i < excess.size(); ++i) {
        std::array<numeric::Interval, 3> box;
        for (std::size_t k = 0; k < 3; ++k) {
            const double part = std::fmod(static_cast<double>(i + 1) * (0.618034 + 0.151 * k), 1.0);
            box[k] = numeric::Interval(2 * part - 1) + numeric::Interval{-half, half};
        }
        const numeric::Interval values = eval::enclose(graph, value, box, parameters);
        excess[i] = (values.hi - values.lo) / (2 * half);
    }
    std::ranges::nth_element(excess, excess.begin() + excess.size() / 2);
    return excess[excess.size() / 2];
}

}  // namespace

std::optional<field::Formula> unrolled(graph::Graph& graph, const field::Iteration& iteration,
                                       std::span<const double> parameters, double limit) {
    const double turns = std::round(limit);
    if (iteration.escape || !(turns <= most_turns)) return std::nullopt;
    std::vector<graph::NodeId> state = iteration.start;
    const auto with_state = [&](std::span<const graph::NodeId> roots) {
        std::vector<std::pair<graph::VariableId, graph::NodeId>> values;
        for (std::size_t i = 0; i < state.size(); ++i) {
            values.emplace_back(iteration.state[i], state[i]);
        }
        return substitute(graph, roots, values);
    };
    for (double turn = 0; turn < turns; ++turn) state = with_state(iteration.step);
    const graph::NodeId value = with_state(std::array{iteration.distance})[0];
    if (reachable(graph, std::array{value}).size() > most_nodes) return std::nullopt;
    constexpr double most_excess = 200;
    if (!(heuristic_excess(graph, value, parameters) <= most_excess)) return std::nullopt;
    field::Formula formula;
    formula.value = value;
    formula.metric = field::Metric::distance;
    return formula;
}

}  // namespace oracle
