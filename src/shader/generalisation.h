// SPDX-License-Identifier: MIT
// Expressions that are equal up to their numbers (anti-unification, Plotkin 1970).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/graph.h"

namespace shader {

/// Expressions up to what does not depend on variables.
struct Generalisation {
    /// Operators, variables, and places of numbers: equal for expressions that are alike. Empty if
    /// the expressions are too large.
    std::vector<std::uint32_t> pattern;
    /// The constants and expressions of parameters at those places.
    std::vector<graph::NodeId> numbers;
};

/// `depends` is graph::depends_on_variables. Takes time in proportion to the expressions. A
/// coordinate counts as itself less 0, so that what was not moved is like what was. The graph may
/// get a 0.
Generalisation generalise(graph::Graph& graph, const std::vector<bool>& depends,
                          std::span<const graph::NodeId> roots);

/// The expressions with others in place of their numbers, in the order of the places.
std::vector<graph::NodeId> with_numbers(graph::Graph& graph, const std::vector<bool>& depends,
                                        std::span<const graph::NodeId> roots,
                                        std::span<const graph::NodeId> numbers);

}  // namespace shader
