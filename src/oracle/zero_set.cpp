// SPDX-License-Identifier: MIT
#include "oracle/zero_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace oracle {
namespace {

using graph::Graph;
using graph::Node;
using graph::NodeId;
using graph::Op;

/// A numerator over a denominator; no denominator is 1. What else must not be 0 is in `guards`.
struct Fraction {
    NodeId above{};
    std::optional<NodeId> below{};
    std::vector<NodeId> guards{};
};

class Finder {
public:
    explicit Finder(Graph& graph) : graph_(graph) {}

    std::vector<ZeroSet> find(NodeId id) {
        visit(id, {});
        return std::move(found_);
    }

private:
    /// Sums of many fractions grow fast.
    static constexpr std::size_t most_fractions = 64;

    void visit(NodeId id, const std::vector<NodeId>& guards) {
        const Node node = graph_[id];
        const auto argument = [&](std::size_t i) { return node.arguments[i]; };
        switch (node.op) {
            case Op::neg:
            case Op::sqrt:
            case Op::cbrt:
            case Op::abs:
            case Op::sinh:
            case Op::tanh:
            case Op::asin:
            case Op::atan:
                return visit(argument(0), guards);
            case Op::exp:
            case Op::cosh:
                return;
            case Op::log:
            case Op::acos:
                return visit(minus_one(argument(0)), guards);
            case Op::tan:
                return visit(graph_.apply(Op::sin, argument(0)), guards);
            case Op::pow:
                return visit_power(id, guards);
            case Op::min:
            case Op::max:
                if (!guards.empty() || !visit_bound(node)) break;
                return;
            case Op::mul:
                visit(argument(0), with_domain(guards, argument(1)));
                if (argument(1) != argument(0)) {
                    visit(argument(1), with_domain(guards, argument(0)));
                }
                return;
            case Op::constant:
                if (node.value != 0) return;
                break;
            case Op::div:
            case Op::add:
            case Op::sub:
                if (const Fraction fraction = as_fraction(id); fraction.below) {
                    std::vector<NodeId> more = guards;
                    add_factors(more, *fraction.below);
                    for (const NodeId guard : fraction.guards) add_factors(more, guard);
                    return visit(fraction.above, more);
                }
                break;
            case Op::variable:
            case Op::parameter:
            case Op::hypot:
            case Op::hypot3:
            case Op::sin:
            case Op::cos:
            case Op::atan2:
            case Op::sign:
            case Op::floor:
            case Op::ceil:
            case Op::ratio:
            case Op::select_less:
                break;
        }
        // Where a factor of a guard is 0 nothing is drawn.
        if (std::ranges::find(guards, id) == guards.end()) found_.push_back({id, guards, false});
    }

    void visit_power(NodeId id, const std::vector<NodeId>& guards) {
        const auto [base, exponent] = std::pair{graph_[id].arguments[0], graph_[id].arguments[1]};
        if (!graph_.is_constant(exponent)) {
            found_.push_back({id, guards, false});
        } else if (graph_[exponent].value > 0) {
            visit(base, guards);
        }
    }

    void add_factors(std::vector<NodeId>& guards, NodeId id) {
        const Node node = graph_[id];
        if (node.op == Op::neg || node.op == Op::mul) {
            for (const NodeId factor : node.args()) add_factors(guards, factor);
        } else if (std::ranges::find(guards, id) == guards.end()) {
            guards.push_back(id);
        }
    }
    /// The maximum or the minimum with 0; false if it is another one.
    bool visit_bound(const Node& node) {
        for (const std::size_t zero : {0, 1}) {
            if (!graph_.is_constant(node.arguments[zero], 0)) continue;
            const NodeId other = node.arguments[1 - zero];
            const NodeId below = node.op == Op::max ? other : graph_.apply(Op::neg, other);
            found_.push_back({below, {}, true});
            return true;
        }
        return false;
    }

    NodeId minus_one(NodeId id) { return graph_.apply(Op::sub, id, graph_.constant(1)); }

    /// A factor that may be undefined must be defined: 1 + |factor| is then not 0.
    std::vector<NodeId> with_domain(std::vector<NodeId> guards, NodeId factor) {
        if (may_be_undefined(factor)) {
            guards.push_back(
                graph_.apply(Op::add, graph_.constant(1), graph_.apply(Op::abs, factor)));
        }
        return guards;
    }
    bool may_be_undefined(NodeId id) const {
        return std::ranges::any_of(reachable(graph_, std::array{id}), [&](NodeId each) {
            const Op op = graph_[each].op;
            return op == Op::div || op == Op::pow || op == Op::sqrt || op == Op::asin ||
                   op == Op::acos || op == Op::log || op == Op::tan;
        });
    }

    NodeId product(NodeId a, std::optional<NodeId> b) {
        return b ? graph_.apply(Op::mul, a, *b) : a;
    }
    std::optional<NodeId> product(std::optional<NodeId> a, std::optional<NodeId> b) {
        return a ? product(*a, b) : b;
    }

    Fraction as_fraction(NodeId id) {
        const auto known = fractions_.find(id);
        if (known != fractions_.end()) return known->second;
        const Fraction fraction = new_fraction(id);
        return fractions_.emplace(id, fraction).first->second;
    }
    Fraction new_fraction(NodeId id) {
        const Node node = graph_[id];
        if (node.op == Op::tan) {
            return {graph_.apply(Op::sin, node.arguments[0]),
                    graph_.apply(Op::cos, node.arguments[0])};
        }
        if (node.op == Op::neg) {
            Fraction a = as_fraction(node.arguments[0]);
            if (a.below) a.above = graph_.apply(Op::neg, a.above);
            return a.below ? a : Fraction{id};
        }
        const bool sum = node.op == Op::add || node.op == Op::sub;
        if (!sum && node.op != Op::mul && node.op != Op::div) return {id};
        const Fraction a = as_fraction(node.arguments[0]), b = as_fraction(node.arguments[1]);
        const bool divides = node.op == Op::div && !graph_.is_constant(node.arguments[1]);
        if (!divides && !a.below && !b.below) return {id};
        if (fractions_.size() > most_fractions) return {id};
        Fraction result{.above = {}, .below = product(a.below, b.below), .guards = a.guards};
        result.guards.insert(result.guards.end(), b.guards.begin(), b.guards.end());
        if (divides) {
            result.above = product(a.above, b.below);
            result.below = product(b.above, a.below);
            if (b.below) result.guards.push_back(*b.below);
        } else if (!sum) {
            result.above = graph_.apply(node.op, a.above, b.above);
        } else if (a.below == b.below) {
            result.above = graph_.apply(node.op, a.above, b.above);
            result.below = a.below;
        } else {
            result.above =
                graph_.apply(node.op, product(a.above, b.below), product(b.above, a.below));
        }
        return result;
    }

    Graph& graph_;
    std::vector<ZeroSet> found_;
    std::map<NodeId, Fraction> fractions_;
};

}  // namespace

std::vector<ZeroSet> zero_sets(Graph& graph, NodeId id) { return Finder(graph).find(id); }

}  // namespace oracle
