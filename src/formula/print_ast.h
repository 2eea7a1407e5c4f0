// SPDX-License-Identifier: MIT
// A program's syntax tree as text, for people and tests.
#pragma once

#include <string>

#include "formula/ast.h"

namespace formula {

/// One node a line, its parts below it, indented by two spaces each level. The same program always
/// gives the same text. Names and numbers stand for themselves; operands of a chain are marked with
/// their sign, an implied product with `.`; the last part is headed `formula`.
std::string print_ast(const Program& program);

/// The tree below one expression, in the same form.
std::string print_ast(const Program& program, ExpressionId id);

}  // namespace formula
