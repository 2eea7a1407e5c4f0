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

}  // namespace

bool may_be_undefined(const graph::Graph& graph, graph::NodeId root) {
    const std::vector<bool> depends = depends_on_variables(graph);
    return std::ranges::any_of(reachable(graph, std::array{root}), [&](graph::NodeId id) {
        // A parameter's expression may be undefined as well, but then it is so everywhere.
        const graph::Node& node = graph[id];
        if (!is_partial(node.op) || !depends[index(id)]) return false;
        // A constant divisor other than 0 never fails.
        return node.op != Op::div || !graph.is_constant(node.arguments[1]) ||
               graph.is_constant(node.arguments[1], 0);
    });
}

}  // namespace shader
