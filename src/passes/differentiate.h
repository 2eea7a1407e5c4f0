// SPDX-License-Identifier: MIT
// Derivatives of expressions as expressions, which share what they can with the value.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "graph/graph.h"

namespace passes {

/// A variable that moves, and how fast.
struct Seed {
    graph::VariableId variable{};
    graph::NodeId slope{};
};

/// The derivative of each root while the variables of the seeds move at their speeds and all others
/// rest: with one seed of slope 1 the partial derivative. Nothing is simplified.
///
/// Where there is a kink, the derivative is one of those of its sides, or the middle: of min and
/// max that of the first argument where both are equal, of abs 0; a length (hypot) has 0 where it
/// is 0; select_less that of the branch taken. Of floor, ceil and sign it is 0 everywhere, also
/// where they jump. The interval enclosure of a derivative `jumps` on each box with such a place
/// (numeric/interval.h). Where the chain rule meets an infinity (sqrt, cbrt and a power below 1 at
/// 0, asin and acos at 1 and -1) the derivative is infinite or NaN. Where a length is 0 all its
/// derivatives are, so that what stays 0 (max(u, 0) inside of a box) disturbs nothing.
std::vector<graph::NodeId> differentiate(graph::Graph& graph, std::span<const graph::NodeId> roots,
                                         std::span<const Seed> seeds);

/// The partial derivative by a variable.
graph::NodeId differentiate(graph::Graph& graph, graph::NodeId root, graph::VariableId by);

/// The partial derivatives of each root by x, y and z, passed through the passes all together.
std::vector<std::array<graph::NodeId, 3>> gradients(graph::Graph& graph,
                                                    std::span<const graph::NodeId> roots);

/// The same for one root.
std::array<graph::NodeId, 3> gradient(graph::Graph& graph, graph::NodeId root);

}  // namespace passes
