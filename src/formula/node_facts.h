// SPDX-License-Identifier: MIT
// What is known about nodes while a formula becomes a graph: which depend on the point, and the
// values of those that depend on nothing.
#pragma once

#include <optional>
#include <vector>

#include "graph/graph.h"

namespace formula {

/// Follows a graph as it grows; each node is looked at once.
class NodeFacts {
public:
    /// True if the node depends on x, y, z or the state of an iteration.
    bool depends_on_point(const graph::Graph& graph, graph::NodeId id);
    /// The value of a node that depends neither on the point nor on parameters or the time; may be
    /// NaN or infinite.
    std::optional<double> constant(const graph::Graph& graph, graph::NodeId id);

private:
    struct Fact {
        bool point = false;
        bool constant = true;
        double value = 0;
    };
    const Fact& fact(const graph::Graph& graph, graph::NodeId id);
    Fact find(const graph::Node& node) const;

    std::vector<Fact> facts_;
};

}  // namespace formula
