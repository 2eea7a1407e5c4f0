// SPDX-License-Identifier: MIT
// The inverse of recognise_hypot, for code that shares squares between lengths and all else.
#pragma once

#include "graph/graph.h"

namespace passes {

/// Makes of a node whose arguments have been rewritten already
/// - hypot(a, b) -> sqrt(a^2 + b^2), which may overflow where the length does not,
/// - the square of a length -> the sum of squares,
/// - ratio(a, r) * ratio(b, r) -> a * b * (1 / max(r^2, 1e-36)) where r is a length: exact but for
///   rounding where r is above 1e-18, and 0 at 0.
graph::NodeId spell_out_lengths(graph::Graph& graph, graph::NodeId id);

/// What is under the root of a length: a square or a sum of squares.
bool is_sum_of_squares(const graph::Graph& graph, graph::NodeId id);

}  // namespace passes
