// SPDX-License-Identifier: MIT
// The expressions of a shape while it is made. Internal to the library.
#pragma once

#include <span>
#include <vector>

#include "graph/graph.h"
#include "oracle/shape.h"

namespace oracle {

/// Collects expressions; then takes out of all of them what may jump, and makes their tapes.
class Expressions {
public:
    explicit Expressions(graph::Graph& graph) : graph_(graph) {}

    /// The number that the expression will have.
    std::size_t add(std::span<const graph::NodeId> roots);
    std::size_t add(graph::NodeId root) { return add(std::span(&root, 1)); }

    /// Fills in the expressions, the cuts and which solid needs which cuts.
    void finish(Shape& shape);

private:
    std::vector<graph::NodeId> without_jumps(Shape& shape);
    std::vector<std::size_t> cuts_of(std::span<const graph::NodeId> roots) const;

    graph::Graph& graph_;
    std::vector<std::vector<graph::NodeId>> roots_;
    std::vector<std::size_t> cut_of_variable_;     ///< by VariableId; none: beyond all cuts
    std::vector<std::vector<std::size_t>> needs_;  ///< of each cut: others
};

}  // namespace oracle
