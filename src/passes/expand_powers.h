// SPDX-License-Identifier: MIT
// Whole powers by multiplication.
#pragma once

#include <span>
#include <vector>

#include "graph/graph.h"

namespace passes {

/// Constant whole exponents up to 64 become multiplications, as few as possible, and powers of one
/// base help each other: x^2 and x^6 together take three. Products of powers of one base count as
/// powers, (x^2)^3 and x * x * x too. A negative exponent becomes the reciprocal of such, 1/2 and
/// -1/2 square roots. The power of 0 of anything but a leaf stays, because the base may be
/// undefined. Up to rounding: each multiplication rounds once.
std::vector<graph::NodeId> expand_powers(graph::Graph& graph, std::span<const graph::NodeId> roots);

}  // namespace passes
