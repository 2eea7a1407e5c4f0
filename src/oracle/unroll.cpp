// SPDX-License-Identifier: MIT
#include "oracle/unroll.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "graph/substitute.h"

namespace oracle {
namespace {

constexpr double most_turns = 64;
constexpr std::size_t most_nodes = 3000;

}  // namespace

std::optional<field::Formula> unrolled(graph::Graph& graph, const field::Iteration& iteration,
                                       double limit) {
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
    field::Formula formula;
    formula.value = value;
    formula.metric = field::Metric::distance;
    return formula;
}

}  // namespace oracle
