// SPDX-License-Identifier: MIT
// Functions that a text defines: their bodies are lowered anew at every call, so that types follow
// from the arguments. Internal to the library.
#pragma once

#include <span>
#include <string>

#include "formula/lowering.h"

namespace formula {

/// The function of a definition in the text that is being lowered, which knows the names that are
/// defined so far. The body is checked on the way, though nothing calls it yet: unknown names,
/// parameters that are never used, and all else that does not depend on the arguments. Nothing if
/// there was an error.
Value define_function(Lowering& lowering, const Definition& definition);

/// A call as it is written, with arguments by place or by name.
Value call_user_function(Lowering& lowering, const FunctionValue& function, const Call& call);

/// A call of a definition of the library, with the rules of the primitives: what is given for a
/// parameter with an initial value must be the same at every point, and have as many components. A
/// parameter without one takes anything.
Value call_library_function(Lowering& lowering, const FunctionValue& function, const Call& call);

/// A call with values, by place; Nothing stands for an argument that is left out.
Value call_user_function(Lowering& lowering, const FunctionValue& function, base::SourceSpan span,
                         std::span<const Value> arguments);

/// How it is called: `ring(R, w = 0.1)`.
std::string signature(const FunctionValue& function);

}  // namespace formula
