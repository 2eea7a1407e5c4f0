// SPDX-License-Identifier: MIT
// Arithmetic on nodes that leaves out what constants make trivial. Internal to the library.
#pragma once

#include "graph/graph.h"

namespace formula {

/// Computes what is known and drops zeros and ones, so that a turn about a coordinate axis touches
/// only the two other coordinates.
struct TrimmedArithmetic {
    graph::Graph& graph;

    bool both_constant(graph::NodeId a, graph::NodeId b) const {
        return graph.is_constant(a) && graph.is_constant(b);
    }
    double value(graph::NodeId id) const { return graph[id].value; }
    graph::NodeId constant(double value) const { return graph.constant(value); }

    graph::NodeId add(graph::NodeId a, graph::NodeId b) const {
        if (both_constant(a, b)) return constant(value(a) + value(b));
        if (graph.is_constant(a, 0)) return b;
        if (graph.is_constant(b, 0)) return a;
        return graph.apply(graph::Op::add, a, b);
    }
    graph::NodeId sub(graph::NodeId a, graph::NodeId b) const {
        if (both_constant(a, b)) return constant(value(a) - value(b));
        if (graph.is_constant(b, 0)) return a;
        return graph.apply(graph::Op::sub, a, b);
    }
    graph::NodeId mul(graph::NodeId a, graph::NodeId b) const {
        if (both_constant(a, b)) return constant(value(a) * value(b));
        if (graph.is_constant(a, 0) || graph.is_constant(b, 0)) return constant(0);
        if (graph.is_constant(a, 1)) return b;
        if (graph.is_constant(b, 1)) return a;
        return graph.apply(graph::Op::mul, a, b);
    }
};

}  // namespace formula
