// SPDX-License-Identifier: MIT
// Identities of arithmetic that keep the value.
#pragma once

#include "graph/graph.h"

namespace passes {

/// Rule. All of it is exact, but for the sign of a zero, and defined where it was:
/// - neutral operands go (x + 0, x - 0, x * 1, x / 1; 0 - x is -x);
/// - signs join (x + -y, x - -y, -(x - y), x * -1, -x * -y, -x / -y), and go where they do not
///   matter (abs(-x), cos(-x), cosh(-x), hypot(-x, y)) or come out of odd functions (sin(-x) is
///   -sin(x));
/// - what is done twice is done once (--x, abs(abs(x)), floor(ceil(x)), sign(sign(x)), min(x, x)).
/// A product with 0, a difference or quotient of equals, and a choice between equals stay: they are
/// undefined where the other factor, the operands or the comparison are.
graph::NodeId simplify(graph::Graph& graph, graph::NodeId id);

}  // namespace passes
