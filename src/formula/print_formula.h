// SPDX-License-Identifier: MIT
// A program's syntax tree as the text of a formula.
#pragma once

#include <string>

#include "formula/ast.h"

namespace formula {

/// The text of a program without Broken expressions. If the program came from a text, this text has
/// the same tree, spans aside, as long as it is within the limits of length. It has no more
/// brackets than that takes, numbers are as short as they can be, and comments are gone.
std::string print_formula(const Program& program);

}  // namespace formula
