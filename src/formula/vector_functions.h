// SPDX-License-Identifier: MIT
// The functions of vectors: one table with names, arguments and how each becomes nodes. Internal to
// the library.
#pragma once

#include <span>
#include <string_view>

#include "formula/arguments.h"

namespace formula {

/// The arguments of one call, in the order of the slots; each is a number or a vector, and none was
/// given for those that hold Nothing.
struct VectorCall {
    Lowering& lowering;
    std::string_view function;
    base::SourceSpan span;
    std::span<const Value> arguments;
};

struct VectorFunction {
    std::string_view name;
    std::string_view signature;  ///< how a call is written
    std::span<const Slot> slots;
    Value (*build)(const VectorCall&);  ///< Nothing after an error
};

/// All of them, sorted by name.
std::span<const VectorFunction> vector_functions();
const VectorFunction* find_vector_function(std::string_view name);

}  // namespace formula
