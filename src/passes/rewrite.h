// SPDX-License-Identifier: MIT
// Bottom-up rewriting: the traversal that all passes share.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "field/field.h"
#include "graph/graph.h"

namespace passes {

/// A local rewrite: an equivalent of this node, whose arguments have been rewritten already, or the
/// node itself. New nodes go into the same graph.
using Rule = graph::NodeId (*)(graph::Graph&, graph::NodeId);

/// A rewrite of whole expressions: an equivalent of each root, in order.
using Transformation = std::vector<graph::NodeId> (*)(graph::Graph&,
                                                      std::span<const graph::NodeId>);

/// Applies the rule to all that the roots need, arguments before users, each node once.
std::vector<graph::NodeId> rewrite(
    graph::Graph& graph, std::span<const graph::NodeId> roots,
    const std::function<graph::NodeId(graph::Graph&, graph::NodeId)>& rule);

/// The rule as a transformation.
template <Rule rule>
std::vector<graph::NodeId> everywhere(graph::Graph& graph, std::span<const graph::NodeId> roots) {
    return rewrite(graph, roots, rule);
}

/// The places of all expressions of a field, always in the same order.
std::vector<graph::NodeId*> all_expressions(field::Field& field);

}  // namespace passes
