// SPDX-License-Identifier: MIT
#include "oracle/quadratic.h"

#include <algorithm>
#include <array>
#include <utility>

#include "analysis/polynomial_degree.h"
#include "graph/build.h"
#include "graph/substitute.h"
#include "passes/differentiate.h"
#include "passes/pipeline.h"

namespace oracle {
namespace {

using graph::NodeId;
using graph::VariableId;

/// The second derivative by two components of q: of a component of q^2, or of |q|^2.
double bend_of_square(std::size_t component, std::size_t j, std::size_t k) {
    if (component == 0) return j != k ? 0 : j == 0 ? 2 : -2;
    return std::min(j, k) == 0 && std::max(j, k) == component ? 2 : 0;
}
double bend_of_norm(std::size_t j, std::size_t k) { return j == k ? 2 : 0; }

bool is_number(const graph::Graph& graph, NodeId id, double value) {
    return graph[id].op == graph::Op::constant && graph[id].value == value;
}

NodeId derivative(graph::Graph& graph, NodeId root, VariableId by) {
    return passes::run(graph, std::array{passes::differentiate(graph, root, by)})[0];
}

/// A length less a number as squares, which have the same sign; all else as it is.
NodeId without_root(graph::Graph& graph, NodeId escape) {
    const graph::Node node = graph[escape];
    if (node.op != graph::Op::sub) return escape;
    const graph::Node length = graph[node.arguments[0]], bound = graph[node.arguments[1]];
    if (bound.op != graph::Op::constant || bound.value < 0) return escape;
    if (length.op != graph::Op::hypot && length.op != graph::Op::hypot3) return escape;
    graph::Expr squares = -(graph::Expr(graph, bound.value) * bound.value);
    for (const NodeId part : length.args()) {
        squares = squares + graph::Expr(graph, part) * graph::Expr(graph, part);
    }
    return squares.id;
}

/// The rest, if the root is a quadratic form of q with these second derivatives and a rest without
/// q.
template <class Bend>
std::optional<NodeId> rest_of(graph::Graph& graph, NodeId root, std::span<const VariableId> q,
                              Bend bend) {
    // Derivatives of what has kinks or jumps prove nothing.
    if (!analysis::polynomial_degree(graph, std::array{root}, q)) return std::nullopt;
    std::vector<std::pair<VariableId, NodeId>> origin;
    for (const VariableId each : q) origin.emplace_back(each, graph.constant(0));
    const auto at_origin = [&](NodeId id) {
        return passes::run(graph, substitute(graph, std::array{id}, origin))[0];
    };
    for (std::size_t j = 0; j < q.size(); ++j) {
        const NodeId slope = derivative(graph, root, q[j]);
        if (!is_number(graph, at_origin(slope), 0)) return std::nullopt;
        for (std::size_t k = 0; k < q.size(); ++k) {
            if (!is_number(graph, derivative(graph, slope, q[k]), bend(j, k))) return std::nullopt;
        }
    }
    return at_origin(root);
}

}  // namespace

std::optional<Quadratic> quadratic(graph::Graph& graph, const field::Iteration& iteration) {
    if (!iteration.escape) return std::nullopt;
    Quadratic result;
    const std::vector<bool> needed = field::needed_state(graph, iteration, {});
    std::vector<VariableId> q;
    std::vector<NodeId> steps;
    for (std::size_t i = 0; i < needed.size(); ++i) {
        if (!needed[i]) continue;
        q.push_back(iteration.state[i]);
        result.start.push_back(iteration.start[i]);
        steps.push_back(iteration.step[i]);
    }
    if (q.size() != 2 && q.size() != 4) return std::nullopt;
    const auto minus_bound =
        rest_of(graph, without_root(graph, *iteration.escape), q, bend_of_norm);
    if (!minus_bound) return std::nullopt;
    result.minus_bound = *minus_bound;
    for (std::size_t i = 0; i < q.size(); ++i) {
        const auto bend = [&](std::size_t j, std::size_t k) { return bend_of_square(i, j, k); };
        const auto constant = rest_of(graph, steps[i], q, bend);
        if (!constant) return std::nullopt;
        result.constant.push_back(*constant);
    }
    return result;
}

}  // namespace oracle
