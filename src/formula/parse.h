// SPDX-License-Identifier: MIT
// From the text of a formula to its syntax tree.
#pragma once

#include <optional>
#include <string_view>

#include "base/result.h"
#include "formula/ast.h"

namespace formula {

/// What could be understood of a text, and the errors in the rest. Each statement is parsed on its
/// own; a statement with an error has a Broken expression in place of its value.
struct Reading {
    std::optional<Program> program;  ///< none if the text could not be cut into statements
    base::Diagnostics errors;        ///< in the order of the text
};
Reading read(std::string_view text);

/// The program of a text without errors of form. Names are not looked up yet. Any bytes may be
/// given; the limits are those of limits.h.
base::Result<Program> parse(std::string_view text);

}  // namespace formula
