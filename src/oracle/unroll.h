// SPDX-License-Identifier: MIT
// Iterations that always make the same turns, as formulas.
#pragma once

#include <optional>

#include "field/field.h"

namespace oracle {

/// An iteration without escape, its turns written one after the other; nothing if it may escape or
/// would become too large. `limit` is the value of its limit.
std::optional<field::Formula> unrolled(graph::Graph& graph, const field::Iteration& iteration,
                                       double limit);

}  // namespace oracle
