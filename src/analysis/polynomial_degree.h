// SPDX-License-Identifier: MIT
// The degree of an expression as a polynomial.
#pragma once

#include <optional>
#include <span>

#include "graph/graph.h"

namespace analysis {

/// Degrees above count as no polynomial.
inline constexpr int largest_degree = 1'000'000;

/// The largest degree of the roots as polynomials in these variables, whose coefficients may depend
/// on anything else; none if one of them is no polynomial. By structure: at least the true degree,
/// more where the highest terms cancel. In time linear in the graph.
std::optional<int> polynomial_degree(const graph::Graph& graph,
                                     std::span<const graph::NodeId> roots,
                                     std::span<const graph::VariableId> variables);

/// The same for one expression in x, y and z.
std::optional<int> polynomial_degree(const graph::Graph& graph, graph::NodeId root);

}  // namespace analysis
