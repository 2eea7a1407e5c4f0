// SPDX-License-Identifier: MIT
// Iterations that always make the same turns, as formulas.
#pragma once

#include <optional>
#include <span>

#include "field/field.h"

namespace oracle {

/// An iteration without escape, its turns written one after the other; nothing if it may escape,
/// would become too large, or is a long chain of folds, of which intervals tell nothing
/// (heuristic). `limit` is the value of its limit.
std::optional<field::Formula> unrolled(graph::Graph& graph, const field::Iteration& iteration,
                                       std::span<const double> parameters, double limit);

}  // namespace oracle
