// SPDX-License-Identifier: MIT
#include "passes/differentiate.h"

#include <algorithm>
#include <optional>

#include "graph/build.h"
#include "passes/pipeline.h"
#include "passes/power_of.h"

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

    Slope quotient() const { return (da - db * f) / b; }
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
                return da * b + db * a;
            case Op::div:
                return quotient();
            case Op::ratio:  // 0 where both are: what has no length stays that way
                return select(graph, Expr(graph, 0.0), b, quotient(), std::nullopt);
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

/// One sweep from the leaves to the roots.
class Sweep {
public:
    Sweep(Graph& graph, std::span<const NodeId> roots, std::span<const Seed> seeds)
        : graph_(graph), powers_(graph), slopes_(graph.size()) {
        for (const NodeId id : reachable(graph, roots)) slopes_[index(id)] = of(id, seeds);
    }
    NodeId operator[](NodeId id) const { return slopes_[index(id)].value_or(graph_.constant(0)); }

private:
    Slope slope(NodeId id) const {
        const std::optional<NodeId> known = slopes_[index(id)];
        return known ? Slope(Expr(graph_, *known)) : Slope();
    }

    std::optional<NodeId> of(NodeId id, std::span<const Seed> seeds) {
        const Node node = graph_[id];
        if (node.op == Op::variable) {
            const auto found = std::ranges::find(seeds, static_cast<graph::VariableId>(node.symbol),
                                                 &Seed::variable);
            const bool moves = found != seeds.end() && !graph_.is_constant(found->slope, 0);
            return moves ? std::optional(found->slope) : std::nullopt;
        }
        if (node.args().empty()) return std::nullopt;
        const Slope slope = node.op == Op::mul ? of_product(id, node) : of_operator(id, node);
        return slope ? std::optional(slope->id) : std::nullopt;
    }

    /// A product of powers of one base is a power: n x^(n - 1), not a sum of products.
    Slope of_product(NodeId id, const Node& node) {
        const PowerOf power = powers_[id];
        if (power.exponent == 1) return of_operator(id, node);
        const Expr base(graph_, power.base);
        const double n = power.exponent;
        const Expr rest = n == 2 ? base : pow(base, Expr(graph_, n - 1));
        return slope(power.base) * (n * rest);
    }

    Slope of_operator(NodeId id, const Node& node) const {
        const auto [a, b, c, d] = node.arguments;
        const std::size_t arity = node.args().size();
        // Places beyond the arity hold node 0 and are never looked at.
        const Chain chain{graph_,
                          {graph_, id},
                          {graph_, a},
                          {graph_, b},
                          {graph_, c},
                          slope(a),
                          arity > 1 ? slope(b) : Slope(),
                          arity > 2 ? slope(c) : Slope(),
                          arity > 3 ? slope(d) : Slope()};
        return chain.of(node.op);
    }

    Graph& graph_;
    Powers powers_;
    std::vector<std::optional<NodeId>> slopes_;  ///< by node; empty is zero by structure
};

}  // namespace

std::vector<NodeId> differentiate(Graph& graph, std::span<const NodeId> roots,
                                  std::span<const Seed> seeds) {
    const Sweep sweep(graph, roots, seeds);
    std::vector<NodeId> slopes;
    for (const NodeId root : roots) slopes.push_back(sweep[root]);
    return slopes;
}

NodeId differentiate(Graph& graph, NodeId root, graph::VariableId by) {
    const std::array seed{Seed{by, graph.constant(1)}};
    return differentiate(graph, std::array{root}, seed)[0];
}

std::vector<std::array<NodeId, 3>> gradients(Graph& graph, std::span<const NodeId> roots) {
    std::vector<NodeId> all;
    for (const graph::VariableId by : {graph::variable_x, graph::variable_y, graph::variable_z}) {
        const std::array seed{Seed{by, graph.constant(1)}};
        std::ranges::copy(differentiate(graph, roots, seed), std::back_inserter(all));
    }
    const std::vector<NodeId> simple = run(graph, all);
    std::vector<std::array<NodeId, 3>> result;
    for (std::size_t i = 0; i < roots.size(); ++i) {
        result.push_back({simple[i], simple[i + roots.size()], simple[i + 2 * roots.size()]});
    }
    return result;
}

std::array<NodeId, 3> gradient(Graph& graph, NodeId root) {
    return gradients(graph, std::array{root})[0];
}

}  // namespace passes
