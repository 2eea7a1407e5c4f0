// SPDX-License-Identifier: MIT
// Calling what is called with values: functions of numbers and vectors, and the user's own.
// Internal to the library.
#pragma once

#include <span>

#include "formula/functions.h"
#include "formula/lowering.h"
#include "formula/vector_functions.h"

namespace formula {

// Each answers Nothing after an error at the span, and without one if an argument is Nothing.

/// A function of numbers, to each component if it is given vectors.
Value apply(Lowering& lowering, const Function& function, base::SourceSpan span,
            std::span<const Value> arguments);

/// A function of vectors: as many values as it has slots, Nothing for those that are left out.
Value apply(Lowering& lowering, const VectorFunction& function, base::SourceSpan span,
            std::span<const Value> arguments);

/// Any function that is a value, by place: what maps of space and the like call. An error if it
/// cannot take as many arguments, or is called with fields as primitives and set operations are.
Value apply(Lowering& lowering, const FunctionValue& function, base::SourceSpan span,
            std::span<const Value> arguments);

/// The user's function of an expression, for maps: an error if it is something else. `role` ends
/// the sentence "... is no function, so it cannot be ...".
std::optional<FunctionValue> as_function(Lowering& lowering, ExpressionId id,
                                         std::string_view role);

}  // namespace formula
