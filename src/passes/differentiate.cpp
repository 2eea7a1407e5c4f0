// SPDX-License-Identifier: MIT
#include "passes/differentiate.h"

#include <optional>
#include <unordered_map>

#include "graph/build.h"
#include "passes/pipeline.h"

namespace passes {
namespace {

using graph::Expr;
using graph::Graph;
using graph::Node;
using graph::NodeId;
using graph::Op;

/// A derivative; empty is zero by structure, so that no product with 0 is ever built.
using Slope = std::optional<Expr>;

Slope operator-(const Slope& a) { return a ? Slope(-*a) : a; }
Slope operator+(const Slope& a, const Slope& b) { return a && b ? Slope(*a + *b) : (a ? a : b); }
Slope operator-(const Slope& a, const Slope& b) { return a && b ? Slope(*a - *b) : (a ? a : -b); }
Slope operator*(const Slope& a, Expr factor) {
    if (!a) return a;
    if (a->graph->is_constant(a->id, 1)) return factor;
    return *a * factor;
}
Slope operator/(const Slope& a, Expr divisor) { return a ? Slope(*a / divisor) : a; }

Expr or_zero(Graph& graph, const Slope& a) { return a ? *a : Expr(graph, 0.0); }

Slope select(Graph& graph, Expr less, Expr than, const Slope& then, const Slope& otherwise) {
    if (!then && !otherwise) return std::nullopt;
    return select_less(less, than, or_zero(graph, then), or_zero(graph, otherwise));
}

/// The chain rule for one node: f is the node, a to d are its arguments, da to dd their
/// derivatives.
struct Chain {
    Graph& graph;
    Expr f, a, b, c;
    Slope da, db, dc, dd;

    Slope power() const {
        if (!db) return da * (b * pow(a, b - 1.0));
        return (db * log(a) + da * b / a) * f;
    }
    Slope angle() const {  // f = atan2(a, b)
        return (da * b - db * a) / (a * a + b * b);
    }
    Slope length3() const { return da * ratio(a, f) + db * ratio(b, f) + dc * ratio(c, f); }

    Slope of(Op op) const {
        switch (op) {
            case Op::constant:
            case Op::variable:
            case Op::parameter:
                return std::nullopt;  // handled by the caller
            case Op::neg:
                return -da;
            case Op::add:
                return da + db;
            case Op::sub:
                return da - db;
            case Op::mul:
                return a.id == b.id ? da * (2.0 * a) : da * b + db * a;
            case Op::div:
            case Op::ratio:
                return (da - db * f) / b;
            case Op::pow:
                return power();
            case Op::sqrt:
                return da * (0.5 / f);
            case Op::cbrt:
                return da / (3.0 * f * f);
            case Op::hypot:
                return da * ratio(a, f) + db * ratio(b, f);
            case Op::hypot3:
                return length3();
            case Op::sin:
                return da * cos(a);
            case Op::cos:
                return -(da * sin(a));
            case Op::tan:
                return da * (1.0 + f * f);
            case Op::asin:
                return da / sqrt(1.0 - a * a);
            case Op::acos:
                return -(da / sqrt(1.0 - a * a));
            case Op::atan:
                return da / (1.0 + a * a);
            case Op::atan2:
                return angle();
            case Op::sinh:
                return da * apply(Op::cosh, a);
            case Op::cosh:
                return da * apply(Op::sinh, a);
            case Op::tanh:
                return da * (1.0 - f * f);
            case Op::exp:
                return da * f;
            case Op::log:
                return da / a;
            case Op::abs:
                return da * sign(a);
            case Op::sign:
            case Op::floor:
            case Op::ceil:
                return std::nullopt;
            case Op::min:
                return select(graph, b, a, db, da);
            case Op::max:
                return select(graph, a, b, db, da);
            case Op::select_less:
                return select(graph, a, b, dc, dd);
        }
        return std::nullopt;
    }
};

}  // namespace

NodeId differentiate(Graph& graph, NodeId root, graph::VariableId by) {
    std::unordered_map<NodeId, NodeId> slopes;  // only of nodes with a derivative
    const auto slope_of = [&](NodeId id) {
        const auto found = slopes.find(id);
        return found == slopes.end() ? Slope() : Slope(Expr(graph, found->second));
    };
    for (NodeId id : reachable(graph, std::array{root})) {
        const Node node = graph[id];
        if (node.op == Op::variable && node.symbol == index(by)) {
            slopes[id] = graph.constant(1);
            continue;
        }
        if (node.args().empty()) continue;
        const auto [a, b, c, d] = node.arguments;
        // Slopes of unused places are those of node 0 and are never looked at.
        const std::size_t arity = node.args().size();
        const Chain chain{graph,
                          {graph, id},
                          {graph, a},
                          {graph, b},
                          {graph, c},
                          slope_of(a),
                          arity > 1 ? slope_of(b) : Slope(),
                          arity > 2 ? slope_of(c) : Slope(),
                          arity > 3 ? slope_of(d) : Slope()};
        if (const Slope slope = chain.of(node.op)) slopes[id] = slope->id;
    }
    const Slope slope = slope_of(root);
    return slope ? slope->id : graph.constant(0);
}

std::array<NodeId, 3> gradient(Graph& graph, NodeId root) {
    const std::array roots{differentiate(graph, root, graph::variable_x),
                           differentiate(graph, root, graph::variable_y),
                           differentiate(graph, root, graph::variable_z)};
    const std::vector<NodeId> simple = run(graph, roots);
    return {simple[0], simple[1], simple[2]};
}

}  // namespace passes
