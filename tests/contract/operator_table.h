// SPDX-License-Identifier: MIT
// The promises of analysis/operator_accuracy.h at single points, for comparing evaluators there.
#pragma once

#include <array>

#include "analysis/operator_accuracy.h"

namespace contract {

using analysis::Range;
using analysis::Unit;
using Row = analysis::Accuracy;

/// Arguments of one operator, in single precision from the start, so that all evaluators see the
/// same numbers; those beyond its arity do not count.
using Arguments = std::array<float, graph::max_arity>;

/// True where an operator's precondition holds: for others nothing at all is promised.
bool is_allowed(graph::Op op, const Arguments& arguments);

/// True where the row's bound is promised.
bool is_promised(const Row& row, const Arguments& arguments);

/// The unit in words, for messages.
const char* name_of(Unit unit);

}  // namespace contract
