// SPDX-License-Identifier: MIT
#include "shader/domain.h"

#include <algorithm>
#include <array>

namespace shader {
namespace {

using graph::Op;

bool is_partial(Op op) {
    constexpr std::array partial{Op::div, Op::pow, Op::sqrt, Op::log, Op::asin, Op::acos, Op::tan};
    return std::ranges::find(partial, op) != partial.end();
}

/// The reciprocal that a division by a parameter has become (passes/divide_by_constants.h), which
/// may be infinite.
bool is_reciprocal(const graph::Graph& graph, graph::NodeId id) {
    const graph::Node& node = graph[id];
    if (node.op == Op::div) return graph.is_constant(node.arguments[0], 1);
    return (node.op == Op::mul || node.op == Op::neg) &&
           std::ranges::any_of(node.args(), [&](auto a) { return is_reciprocal(graph, a); });
}

}  // namespace

bool may_be_undefined(const graph::Graph& graph, std::span<const graph::NodeId> roots) {
    const std::vector<bool> depends = depends_on_variables(graph);
    return std::ranges::any_of(reachable(graph, roots), [&](graph::NodeId id) {
        // A parameter's expression may be undefined as well, but then it is so everywhere.
        const graph::Node& node = graph[id];
        if (!depends[index(id)]) return false;
        if (node.op == Op::mul) {
            return std::ranges::any_of(node.args(), [&](graph::NodeId a) {
                return !depends[index(a)] && is_reciprocal(graph, a);
            });
        }
        if (!is_partial(node.op)) return false;
        // A constant divisor other than 0 never fails.
        return node.op != Op::div || !graph.is_constant(node.arguments[1]) ||
               graph.is_constant(node.arguments[1], 0);
    });
}

}  // namespace shader
