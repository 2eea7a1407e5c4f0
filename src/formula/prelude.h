// SPDX-License-Identifier: MIT
// The fields that the language itself defines: prelude/NAME.zeroset holds one function NAME, with a
// comment above it that says what it is.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace formula {

struct FunctionValue;

/// The names of all of them, sorted.
const std::vector<std::string_view>& prelude_names();
bool is_in_prelude(std::string_view name);

/// The function of a name that is in the prelude; parsed on first use, by any thread.
const FunctionValue& prelude_function(std::string_view name);

/// What it is, in the words of the comment above it, on one line.
std::string prelude_summary(std::string_view name);

}  // namespace formula
