// SPDX-License-Identifier: MIT
#include "passes/live_nodes.h"

#include <optional>

namespace passes {

using graph::Node;
using graph::NodeId;

LiveNodes::LiveNodes(graph::Graph& graph, std::span<const NodeId> roots)
    : graph_(graph), rates_(graph), uses_(graph.size(), 0) {
    for (const NodeId root : roots) change(root, Change::use);
}

bool LiveNodes::is_operation(NodeId id) {
    return !graph_[id].args().empty() && rates_[id] >= Rate::point;
}

/// The node itself has become needed, or is needed no more.
void LiveNodes::change_operands(NodeId id, Change what, std::vector<NodeId>& open) {
    if (const auto found = replacement_.find(id); found != replacement_.end()) {
        open.push_back(found->second);
        return;
    }
    if (is_operation(id)) operations_ += what == Change::use ? 1 : -1;
    for (const NodeId argument : graph_[id].args()) open.push_back(argument);
}

void LiveNodes::change(NodeId first, Change what) {
    if (uses_.size() < graph_.size()) uses_.resize(graph_.size(), 0);
    std::vector<NodeId> open{first};
    while (!open.empty()) {
        const NodeId id = open.back();
        open.pop_back();
        std::uint32_t& uses = uses_[index(id)];
        const bool turns = what == Change::use ? uses++ == 0 : --uses == 0;
        if (turns) change_operands(id, what, open);
    }
}

void LiveNodes::replace_if_cheaper(NodeId id, NodeId by) {
    if (by == id) return;
    const long before = operations_;
    std::vector<NodeId> operands;
    change_operands(id, Change::drop, operands);
    change(by, Change::use);  // first, so that what both need stays
    for (const NodeId operand : operands) change(operand, Change::drop);
    if (operations_ < before) {
        replacement_[id] = by;
        return;
    }
    operands.clear();
    change_operands(id, Change::use, operands);
    for (const NodeId operand : operands) change(operand, Change::use);
    change(by, Change::drop);
}

std::vector<NodeId> LiveNodes::replaced(std::span<const NodeId> roots) {
    // Replacements have larger numbers than what they replace: no order by number any more.
    std::vector<std::optional<NodeId>> made(graph_.size());
    std::vector<NodeId> open(roots.begin(), roots.end());
    while (!open.empty()) {
        const NodeId id = open.back();
        const auto found = replacement_.find(id);
        Node node = graph_[id];
        const std::span<const NodeId> operands =
            found == replacement_.end() ? node.args() : std::span(&found->second, 1);
        bool ready = true;
        for (const NodeId operand : operands) {
            if (made[index(operand)]) continue;
            open.push_back(operand);
            ready = false;
        }
        if (!ready) continue;
        open.pop_back();
        if (made[index(id)]) continue;
        if (found != replacement_.end()) {
            made[index(id)] = made[index(found->second)];
        } else if (operands.empty()) {
            made[index(id)] = id;
        } else {
            for (std::size_t i = 0; i < operands.size(); ++i) {
                node.arguments[i] = *made[index(node.arguments[i])];
            }
            made[index(id)] = graph_.apply(node.op, node.args());
        }
    }
    std::vector<NodeId> result;
    for (const NodeId root : roots) result.push_back(*made[index(root)]);
    return result;
}

}  // namespace passes
