// SPDX-License-Identifier: MIT
// What a polynomial in x, y and z becomes along a ray.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "graph/graph.h"

namespace passes {

/// The coefficients a_0, a_1, ... of the polynomial f(p + s d) in s, for the point p and the vector
/// d that these nodes hold, by polynomial arithmetic over the graph; passed through the passes.
/// None if f is no polynomial in x, y and z by its structure, or one of a degree above
/// `largest_degree`. The degree is that of the structure: where the highest terms cancel, the last
/// coefficients are zero up to rounding. The nodes of p and d must not depend on x, y and z.
std::optional<std::vector<graph::NodeId>> polynomial_along(graph::Graph& graph, graph::NodeId f,
                                                           const std::array<graph::NodeId, 3>& p,
                                                           const std::array<graph::NodeId, 3>& d,
                                                           std::size_t largest_degree);

}  // namespace passes
