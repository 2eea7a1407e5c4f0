// SPDX-License-Identifier: MIT
#include "oracle/expressions.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "passes/rewrite.h"

namespace oracle {
namespace {

using graph::NodeId;
using graph::Op;

bool may_jump(Op op) {
    return op == Op::floor || op == Op::ceil || op == Op::sign || op == Op::select_less ||
           op == Op::atan2;
}

void merge(std::vector<std::size_t>& list, const std::vector<std::size_t>& more) {
    list.insert(list.end(), more.begin(), more.end());
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

std::size_t Expressions::add(std::span<const NodeId> roots) {
    roots_.emplace_back(roots.begin(), roots.end());
    return roots_.size() - 1;
}

/// The cuts whose variables the roots hold, and those that these need, in ascending order.
std::vector<std::size_t> Expressions::cuts_of(std::span<const NodeId> roots) const {
    std::vector<std::size_t> cuts;
    for (const NodeId id : reachable(graph_, roots)) {
        const graph::Node& node = graph_[id];
        if (node.op != Op::variable || node.symbol >= cut_of_variable_.size()) continue;
        const std::size_t cut = cut_of_variable_[node.symbol];
        if (cut >= needs_.size()) continue;
        merge(cuts, {cut});
        merge(cuts, needs_[cut]);
    }
    return cuts;
}

/// All roots one after the other, with variables for what may jump; and the cuts.
std::vector<NodeId> Expressions::without_jumps(Shape& shape) {
    std::vector<NodeId> roots;
    for (const auto& list : roots_) roots.insert(roots.end(), list.begin(), list.end());
    std::map<NodeId, NodeId> known;
    const auto rule = [&](graph::Graph& graph, NodeId id) {
        const graph::Node node = graph[id];
        if (!may_jump(node.op)) return id;
        if (const auto found = known.find(id); found != known.end()) return found->second;
        const std::vector<NodeId> needed = reachable(graph, std::array{id});
        const bool depends = std::ranges::any_of(
            needed, [&](NodeId each) { return graph[each].op == Op::variable; });
        if (!depends) return id;
        const graph::VariableId variable = graph.new_variable("cut");
        const std::size_t number = shape.cuts.size();
        needs_.push_back(cuts_of(node.args()));
        cut_of_variable_.resize(index(variable) + 1, static_cast<std::size_t>(-1));
        cut_of_variable_[index(variable)] = number;
        shape.cuts.push_back({node.op, variable, add(node.args())});
        return known.emplace(id, graph.variable(variable)).first->second;
    };
    return passes::rewrite(graph_, roots, rule);
}

void Expressions::finish(Shape& shape) {
    const std::size_t own = roots_.size();
    const std::vector<NodeId> changed = without_jumps(shape);
    for (std::size_t i = 0, next = 0; i < roots_.size(); ++i) {
        if (i < own) {
            for (NodeId& root : roots_[i]) root = changed[next++];
        }
        shape.expressions.push_back({eval::make_tape(graph_, roots_[i]), cuts_of(roots_[i])});
    }
    for (Solid& solid : shape.solids) {
        const bool has_expression =
            solid.what == Solid::What::formula || solid.what == Solid::What::blend;
        if (has_expression) merge(solid.cuts, shape.expressions[solid.source].cuts);
        if (solid.what == Solid::What::loop) {
            if (const auto& turns = shape.loops[solid.source].quadratic) {
                merge(solid.cuts, shape.expressions[turns->source].cuts);
            }
        }
        for (const std::size_t operand : solid.operands) {
            merge(solid.cuts, shape.solids[operand].cuts);
        }
    }
    shape.variable_count = graph_.variable_count();
}

}  // namespace oracle
