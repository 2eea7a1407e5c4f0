// SPDX-License-Identifier: MIT
#include "analysis/smoothness.h"

#include <algorithm>
#include <array>
#include <vector>

namespace analysis {
namespace {

Smoothness smoothness(graph::Op op) {
    using graph::Op;
    switch (op) {
        case Op::constant:
        case Op::variable:
        case Op::parameter:
        case Op::neg:
        case Op::add:
        case Op::sub:
        case Op::mul:
        case Op::div:
        case Op::pow:
        case Op::sqrt:
        case Op::sin:
        case Op::cos:
        case Op::tan:
        case Op::asin:
        case Op::acos:
        case Op::atan:
        case Op::sinh:
        case Op::cosh:
        case Op::tanh:
        case Op::exp:
        case Op::log:
            return Smoothness::smooth;
        case Op::cbrt:
        case Op::hypot:
        case Op::hypot3:
        case Op::abs:
        case Op::min:
        case Op::max:
            return Smoothness::piecewise;
        case Op::atan2:
        case Op::sign:
        case Op::floor:
        case Op::ceil:
        case Op::ratio:
        case Op::select_less:
            return Smoothness::discontinuous;
    }
    return Smoothness::discontinuous;
}

}  // namespace

Smoothness smoothness(const graph::Graph& graph, graph::NodeId root) {
    const std::vector<bool> depends = graph::depends_on_variables(graph);
    Smoothness worst = Smoothness::smooth;
    for (const graph::NodeId id : graph::reachable(graph, std::array{root})) {
        if (depends[graph::index(id)]) worst = std::max(worst, smoothness(graph[id].op));
    }
    return worst;
}

}  // namespace analysis
