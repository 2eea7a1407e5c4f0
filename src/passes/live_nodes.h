// SPDX-License-Identifier: MIT
// What is still needed while nodes are replaced one after the other.
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "graph/graph.h"
#include "passes/rate.h"

namespace passes {

/// The nodes that some roots need, counted by their uses, and the operations at each point that
/// they take. A replacement is tried by counting, in time of what changes.
class LiveNodes {
public:
    LiveNodes(graph::Graph& graph, std::span<const graph::NodeId> roots);

    bool has(graph::NodeId id) const { return index(id) < uses_.size() && uses_[index(id)] > 0; }

    /// Lets all users of a live node use another instead, which must not need it, if that takes
    /// fewer operations; else nothing changes.
    void replace_if_cheaper(graph::NodeId id, graph::NodeId by);

    /// The roots with all replacements made.
    std::vector<graph::NodeId> replaced(std::span<const graph::NodeId> roots);

private:
    enum class Change { use, drop };
    void change(graph::NodeId first, Change what);
    void change_operands(graph::NodeId id, Change what, std::vector<graph::NodeId>& open);
    bool is_operation(graph::NodeId id);

    graph::Graph& graph_;
    Rates rates_;
    std::vector<std::uint32_t> uses_;
    std::unordered_map<graph::NodeId, graph::NodeId> replacement_;
    long operations_ = 0;
};

}  // namespace passes
