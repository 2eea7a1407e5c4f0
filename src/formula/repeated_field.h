// SPDX-License-Identifier: MIT
// The fields that a function gives for 1, 2, 3 and so on: operands of unions. Internal to the
// library.
#pragma once

#include <optional>
#include <vector>

#include "formula/set_operations.h"

namespace formula {

/// Whether the call's first argument is a function that stands for such fields.
bool has_repeated_field(Lowering& lowering, const Call& call);

/// What the function gives for 1 to the whole number that is the second argument; nothing after an
/// error.
std::optional<std::vector<FieldOperand>> repeated_field(Lowering& lowering, const Call& call);

}  // namespace formula
