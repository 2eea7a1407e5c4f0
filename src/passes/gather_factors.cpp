// SPDX-License-Identifier: MIT
#include "passes/gather_factors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "passes/addition_chain.h"
#include "passes/operation_count.h"
#include "passes/order_operands.h"
#include "passes/power_of.h"
#include "passes/rate.h"
#include "passes/tree.h"

namespace passes {
namespace {

using graph::Graph;
using graph::Node;
using graph::NodeId;
using graph::Op;

/// Where a constant goes among the factors of a product.
enum class Coefficient { inside, outside };

class Regrouping {
public:
    Regrouping(Graph& graph, std::span<const NodeId> roots, Coefficient place)
        : graph_(graph),
          place_(place),
          rates_(graph),
          powers_(graph),
          usage_(usage(graph, roots)),
          inner_(inner_nodes(graph, usage_, std::array{Op::mul, Op::neg})),
          made_(graph.size()) {
        // Inner nodes are built as well: they stay where a product has nothing to regroup.
        for (const NodeId id : usage_.order) made_[index(id)] = build(id);
    }
    NodeId operator[](NodeId id) const { return made_[index(id)]; }

private:
    struct Factor {
        NodeId id{};
        Rate rate{};
    };

    NodeId build(NodeId id) {
        Node node = graph_[id];
        if (node.args().empty()) return id;
        if ((node.op == Op::mul || node.op == Op::neg) && !inner_[index(id)]) {
            if (const std::optional<NodeId> product = regrouped(id)) return *product;
        }
        for (NodeId& argument : node.arguments) argument = made_[index(argument)];
        return graph_.apply(node.op, node.args());
    }

    /// The leaves of a product from left to right, rewritten; constants and signs go into
    /// `coefficient`. `parts` counts the operators.
    std::vector<NodeId> leaves_of(NodeId root, double& coefficient, std::size_t& parts) const {
        std::vector<NodeId> leaves, open{root};
        while (!open.empty()) {
            const NodeId id = open.back();
            open.pop_back();
            const Node& node = graph_[id];
            if (id != root && !inner_[index(id)]) {
                if (graph_.is_constant(id)) {
                    coefficient *= node.value;
                } else {
                    leaves.push_back(made_[index(id)]);
                }
                continue;
            }
            ++parts;
            if (node.op == Op::neg) coefficient = -coefficient;
            for (std::size_t i = node.args().size(); i-- > 0;) open.push_back(node.args()[i]);
        }
        return leaves;
    }

    /// Equal bases become powers, as far as the exponent stays small.
    std::vector<Factor> factors_of(const std::vector<NodeId>& leaves) {
        std::vector<PowerOf> powers;
        for (const NodeId leaf : leaves) powers.push_back(powers_[leaf]);
        std::ranges::stable_sort(powers, {}, &PowerOf::base);
        std::vector<PowerOf> merged;
        for (const PowerOf& power : powers) {
            if (!merged.empty() && merged.back().base == power.base &&
                merged.back().exponent + power.exponent <= largest_chained_exponent) {
                merged.back().exponent += power.exponent;
            } else {
                merged.push_back(power);
            }
        }
        std::vector<Factor> factors;
        for (const auto& [base, exponent] : merged) {
            const NodeId id =
                exponent == 1 ? base : graph_.apply(Op::pow, base, graph_.constant(exponent));
            factors.push_back({id, rates_[id]});
        }
        std::ranges::sort(factors, [&](const Factor& a, const Factor& b) {
            return a.rate != b.rate ? a.rate < b.rate : stands_before(graph_, a.id, b.id);
        });
        return factors;
    }

    /// Nothing if regrouping saves nothing, or if the constants are better left alone.
    std::optional<NodeId> regrouped(NodeId id) {
        if (rates_[id] < Rate::point) return std::nullopt;
        double coefficient = 1;
        std::size_t parts = 0;
        const std::vector<NodeId> leaves = leaves_of(id, coefficient, parts);
        if (!std::isnormal(coefficient)) return std::nullopt;
        const std::vector<Factor> factors = factors_of(leaves);
        // A sign that comes out of a product may go into a sum.
        const bool frees_sign = coefficient == -1 && graph_[id].op == Op::mul;
        if (!frees_sign && !pays(factors, coefficient, parts)) return std::nullopt;
        return product(factors, coefficient);
    }

    /// `parts` is the number of operators and constants that are there now.
    bool pays(const std::vector<Factor>& factors, double coefficient, std::size_t parts) const {
        const bool has_coefficient = coefficient != 1;
        const std::size_t slow = count(factors, Rate::frame) + (has_coefficient ? 1 : 0);
        const bool fast_mixed = count(factors, Rate::turn) > 0 && count(factors, Rate::point) > 1;
        const std::size_t needed = factors.size() - 1 + (has_coefficient ? 1 : 0);
        return slow > 1 || fast_mixed || needed < parts;
    }
    static std::size_t count(const std::vector<Factor>& factors, Rate rate) {
        return static_cast<std::size_t>(std::ranges::count(factors, rate, &Factor::rate));
    }

    NodeId product(const std::vector<Factor>& factors, double coefficient) {
        std::optional<NodeId> result;
        bool open = coefficient != 1;
        const auto put_coefficient = [&](NodeId factor) {
            open = false;
            if (coefficient == -1) return graph_.apply(Op::neg, factor);
            return graph_.apply(Op::mul, graph_.constant(coefficient), factor);
        };
        for (std::size_t i = 0; i < factors.size();) {
            NodeId group = factors[i].id;
            const Rate rate = factors[i].rate;
            if (open && coefficient != -1 && place_ == Coefficient::inside)
                group = put_coefficient(group);
            for (++i; i < factors.size() && factors[i].rate == rate; ++i) {
                group = graph_.apply(Op::mul, group, factors[i].id);
            }
            // Else the slowest group takes it as a whole.
            if (open) group = put_coefficient(group);
            result = result ? graph_.apply(Op::mul, *result, group) : group;
        }
        return *result;
    }

    Graph& graph_;
    Coefficient place_;
    Rates rates_;
    Powers powers_;
    Usage usage_;
    std::vector<bool> inner_;
    std::vector<NodeId> made_;
};

}  // namespace

std::vector<NodeId> gather_factors(Graph& graph, std::span<const NodeId> roots) {
    // Which place lets products share more cannot be told from one product.
    std::vector<NodeId> best;
    std::size_t least = 0;
    for (const Coefficient place : {Coefficient::inside, Coefficient::outside}) {
        const Regrouping regrouping(graph, roots, place);
        std::vector<NodeId> result;
        for (const NodeId root : roots) result.push_back(regrouping[root]);
        const std::size_t cost = count_operations(graph, result).multiplied_out;
        if (!best.empty() && cost >= least) continue;
        best = std::move(result);
        least = cost;
    }
    return best;
}

}  // namespace passes
