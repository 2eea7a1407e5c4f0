// SPDX-License-Identifier: MIT
#include "passes/dual_numbers.h"

#include <algorithm>
#include <iterator>

#include "passes/depends_on.h"
#include "passes/differentiate.h"

namespace passes {
namespace {

using field::Iteration;
using graph::Graph;
using graph::NodeId;
using graph::VariableId;

constexpr std::array point{graph::variable_x, graph::variable_y, graph::variable_z};

/// The state that changes with a coordinate of the point, of what the roots need: all other
/// derivatives by it stay 0.
std::vector<std::size_t> changing_state(const Graph& graph, const Iteration& iteration,
                                        std::span<const NodeId> roots, VariableId coordinate) {
    Iteration endless = iteration;
    endless.escape.reset();
    const std::vector<bool> needed = needed_state(graph, endless, roots);
    std::vector<VariableId> changing{coordinate};
    std::vector<std::size_t> rows;
    // Until no further row is found to change with those that do.
    for (bool more = true; more;) {
        more = false;
        for (std::size_t i = 0; i < needed.size(); ++i) {
            if (!needed[i] || std::ranges::find(rows, i) != rows.end()) continue;
            if (!depends_on(graph, endless.start[i], changing) &&
                !depends_on(graph, endless.step[i], changing)) {
                continue;
            }
            rows.push_back(i);
            changing.push_back(endless.state[i]);
            more = true;
        }
    }
    std::ranges::sort(rows);
    return rows;
}

}  // namespace

std::vector<std::array<NodeId, 3>> add_derivatives(Graph& graph, Iteration& iteration,
                                                   std::span<const NodeId> roots) {
    const Iteration value = iteration;
    std::vector<std::array<NodeId, 3>> result(roots.size());
    for (std::size_t axis = 0; axis < point.size(); ++axis) {
        const VariableId coordinate = point[axis];
        const std::vector<std::size_t> rows = changing_state(graph, value, roots, coordinate);
        std::vector<NodeId> starts, steps;
        for (const std::size_t row : rows) {
            starts.push_back(value.start[row]);
            steps.push_back(value.step[row]);
        }
        std::vector<Seed> seeds{{coordinate, graph.constant(1)}};
        const std::vector<NodeId> start = differentiate(graph, starts, seeds);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const VariableId row = value.state[rows[i]];
            const VariableId slope =
                graph.new_variable("d" + graph.name(row) + "/d" + graph.name(coordinate));
            iteration.state.push_back(slope);
            iteration.start.push_back(start[i]);
            seeds.push_back({row, graph.variable(slope)});
        }
        std::ranges::copy(differentiate(graph, steps, seeds), std::back_inserter(iteration.step));
        const std::vector<NodeId> slopes = differentiate(graph, roots, seeds);
        for (std::size_t i = 0; i < roots.size(); ++i) result[i][axis] = slopes[i];
    }
    return result;
}

}  // namespace passes
