// SPDX-License-Identifier: MIT
#include "passes/gather_terms.h"

#include <algorithm>
#include <array>
#include <optional>

#include "passes/rate.h"
#include "passes/signed_term.h"
#include "passes/tree.h"

namespace passes {
namespace {

using graph::Graph;
using graph::Node;
using graph::NodeId;
using graph::Op;

class Regrouping {
public:
    Regrouping(Graph& graph, std::span<const NodeId> roots)
        : graph_(graph),
          rates_(graph),
          usage_(usage(graph, roots)),
          inner_(inner_nodes(graph, usage_, std::array{Op::add, Op::sub})),
          made_(graph.size()) {
        // Inner nodes are built as well: they stay where a sum has nothing to regroup.
        for (const NodeId id : usage_.order) made_[index(id)] = build(id);
    }
    NodeId operator[](NodeId id) const { return made_[index(id)]; }

private:
    NodeId build(NodeId id) {
        Node node = graph_[id];
        if (node.args().empty()) return id;
        if ((node.op == Op::add || node.op == Op::sub) && !inner_[index(id)]) {
            if (const std::optional<NodeId> grouped = regrouped(id)) return *grouped;
        }
        for (NodeId& argument : node.arguments) argument = made_[index(argument)];
        return graph_.apply(node.op, node.args());
    }

    std::vector<SignedTerm> terms_of(NodeId root) const {
        std::vector<SignedTerm> terms, open{{root, false}};
        while (!open.empty()) {
            const SignedTerm term = open.back();
            open.pop_back();
            if (term.id != root && !inner_[index(term.id)]) {
                terms.push_back({made_[index(term.id)], term.negative});
                continue;
            }
            const Node& node = graph_[term.id];
            open.push_back({node.arguments[1], term.negative != (node.op == Op::sub)});
            open.push_back({node.arguments[0], term.negative});
        }
        return terms;
    }

    /// Nothing if there are no two slow terms of one rate.
    std::optional<NodeId> regrouped(NodeId id) {
        const Rate whole = rates_[id];
        if (whole < Rate::point) return std::nullopt;
        std::vector<SignedTerm> terms = terms_of(id);
        const auto rate = [&](const SignedTerm& term) {
            return std::max(rates_[term.id], Rate::frame);
        };
        const auto slow = [&](Rate r) { return std::ranges::count(terms, r, rate); };
        const bool pays = slow(Rate::frame) > 1 || (whole == Rate::turn && slow(Rate::point) > 1);
        if (!pays) return std::nullopt;
        std::ranges::stable_sort(terms, {}, rate);
        std::optional<SignedTerm> result;
        for (std::size_t i = 0; i < terms.size();) {
            SignedTerm group = terms[i];
            const Rate group_rate = rate(group);
            for (++i; i < terms.size() && rate(terms[i]) == group_rate; ++i) {
                group = sum(graph_, group, terms[i]);
            }
            result = result ? sum(graph_, group, *result) : group;
        }
        return value_of(graph_, *result);
    }

    Graph& graph_;
    Rates rates_;
    Usage usage_;
    std::vector<bool> inner_;
    std::vector<NodeId> made_;
};

}  // namespace

std::vector<NodeId> gather_terms(Graph& graph, std::span<const NodeId> roots) {
    const Regrouping regrouping(graph, roots);
    std::vector<NodeId> result;
    for (const NodeId root : roots) result.push_back(regrouping[root]);
    return result;
}

}  // namespace passes
