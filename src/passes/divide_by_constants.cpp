// SPDX-License-Identifier: MIT
#include "passes/divide_by_constants.h"

#include <cmath>

#include "passes/rate.h"
#include "passes/rewrite.h"

namespace passes {

using graph::Graph;
using graph::NodeId;
using graph::Op;

std::vector<NodeId> divide_by_constants(Graph& graph, std::span<const NodeId> roots) {
    Rates rates(graph);
    return rewrite(graph, roots, [&](Graph& g, NodeId id) {
        const auto [a, b, c, d] = g[id].arguments;
        if (g[id].op != Op::div || rates[a] < Rate::point || rates[b] > Rate::frame) return id;
        if (g.is_constant(b)) {
            const double reciprocal = 1 / g[b].value;
            if (!std::isnormal(reciprocal)) return id;
            return g.apply(Op::mul, g.constant(reciprocal), a);
        }
        return g.apply(Op::mul, g.apply(Op::div, g.constant(1), b), a);
    });
}

}  // namespace passes
