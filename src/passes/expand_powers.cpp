// SPDX-License-Identifier: MIT
#include "passes/expand_powers.h"

#include <array>
#include <cmath>
#include <map>

#include "passes/addition_chain.h"
#include "passes/power_of.h"

namespace passes {
namespace {

using graph::Graph;
using graph::Node;
using graph::NodeId;
using graph::Op;

/// The exponents of one base that are needed, and their nodes once they are built.
using PowersOfBase = std::map<int, NodeId>;

class Expansion {
public:
    Expansion(Graph& graph, std::span<const NodeId> roots)
        : graph_(graph), powers_(graph), order_(reachable(graph, roots)), made_(graph.size()) {
        collect(roots);
        for (const NodeId id : order_) {
            if (needed_[index(id)]) made_[index(id)] = build(id);
        }
    }
    NodeId operator[](NodeId id) { return power(powers_[id]); }

private:
    /// 1 / x^n is written pow(x, -n) as well. The power below the line, or no exponent.
    PowerOf reciprocal(const Node& node) {
        if (node.op != Op::pow || !graph_.is_constant(node.arguments[1])) return {{}, 0};
        const double n = -graph_[node.arguments[1]].value;
        if (!(n >= 1 && n <= largest_chained_exponent && n == std::floor(n))) return {{}, 0};
        const PowerOf base = powers_[node.arguments[0]];
        const int whole = static_cast<int>(n);
        if (whole * base.exponent > largest_chained_exponent) return {node.arguments[0], whole};
        return {base.base, whole * base.exponent};
    }

    void need(PowerOf power) {
        needed_[index(power.base)] = true;
        if (power.exponent > 1) list_[power.base][power.exponent] = {};
    }
    void collect(std::span<const NodeId> roots) {
        needed_.assign(graph_.size(), false);
        for (const NodeId root : roots) need(powers_[root]);
        for (std::size_t i = order_.size(); i-- > 0;) {
            if (!needed_[index(order_[i])]) continue;
            const Node& node = graph_[order_[i]];
            if (const PowerOf below = reciprocal(node); below.exponent > 0) {
                need(below);
                continue;
            }
            for (const NodeId argument : node.args()) need(powers_[argument]);
        }
    }

    NodeId power(PowerOf power) {
        const NodeId base = made_[index(power.base)];
        return power.exponent == 1 ? base : list_.at(power.base).at(power.exponent);
    }
    /// A node that is no power of another; its powers are built along.
    NodeId build(NodeId id) {
        const NodeId base = rebuilt(id);
        const auto found = list_.find(id);
        if (found == list_.end()) return base;
        PowersOfBase& powers = found->second;
        std::vector<int> exponents;
        for (const auto& [exponent, node] : powers) exponents.push_back(exponent);
        powers[1] = base;
        for (const auto& [sum, a, b] : addition_sequence(exponents)) {
            powers[sum] = graph_.apply(Op::mul, powers.at(a), powers.at(b));
        }
        return base;
    }
    NodeId rebuilt(NodeId id) {
        Node node = graph_[id];
        if (node.args().empty()) return id;
        if (const PowerOf below = reciprocal(node); below.exponent > 0) {
            return graph_.apply(Op::div, graph_.constant(1), power(below));
        }
        for (NodeId& argument : node.arguments) {
            if (&argument < node.args().data() + node.args().size()) {
                argument = power(powers_[argument]);
            }
        }
        if (node.op == Op::pow) return root_or_power(node.arguments[0], node.arguments[1]);
        return graph_.apply(node.op, node.args());
    }
    NodeId root_or_power(NodeId base, NodeId exponent) {
        if (graph_.is_constant(exponent, 0.5)) return graph_.apply(Op::sqrt, base);
        if (graph_.is_constant(exponent, -0.5)) {
            return graph_.apply(Op::div, graph_.constant(1), graph_.apply(Op::sqrt, base));
        }
        // What is undefined stays so, also to the power of 0; leaves never are.
        if (graph_.is_constant(exponent, 0) && graph_[base].args().empty()) {
            return graph_.constant(1);
        }
        return graph_.apply(Op::pow, base, exponent);
    }

    Graph& graph_;
    Powers powers_;
    std::vector<NodeId> order_;
    std::vector<NodeId> made_;  ///< by node, of those that are no powers
    std::vector<bool> needed_;
    std::map<NodeId, PowersOfBase> list_;
};

}  // namespace

std::vector<NodeId> expand_powers(Graph& graph, std::span<const NodeId> roots) {
    Expansion expansion(graph, roots);
    std::vector<NodeId> result;
    for (const NodeId root : roots) result.push_back(expansion[root]);
    return result;
}

}  // namespace passes
