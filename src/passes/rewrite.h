// SPDX-License-Identifier: MIT
// Bottom-up rewriting: the traversal that all passes share.
#pragma once

#include <span>
#include <vector>

#include "field/field.h"
#include "graph/graph.h"

namespace passes {

/// A local rewrite: an equivalent of this node, whose arguments have been rewritten already, or the
/// node itself. New nodes go into the same graph.
using Rule = graph::NodeId (*)(graph::Graph&, graph::NodeId);

/// Applies the rule to all that the roots need, arguments before users, each node once.
std::vector<graph::NodeId> rewrite(graph::Graph& graph, std::span<const graph::NodeId> roots,
                                   Rule rule);

/// Applies the rule to every expression of a field, in place.
void rewrite(field::Field& field, Rule rule);

}  // namespace passes
