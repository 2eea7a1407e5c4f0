// SPDX-License-Identifier: MIT
// The grammar. Its source is the only file that includes Boost.Spirit X3.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "base/diagnostic.h"
#include "formula/ast.h"

namespace formula {

/// Where a text leaves the grammar. `expected` is what had to stand there: "expression", "name", a
/// sign in quotes, or "end".
struct SyntaxError {
    std::uint32_t place = 0;
    std::string expected;
};

template <class T>
using Parsed = std::variant<T, SyntaxError>;

/// Parses the bytes of the span as one expression, which is added to the program. Numbers that are
/// too large and trees that are too high are reported in `errors`, beside a tree of the right form.
Parsed<ExpressionId> parse_expression(std::string_view text, base::SourceSpan span,
                                      Program& program, base::Diagnostics& errors);

/// Parses `param name = ...`. In its expressions `in` and `step` without brackets are no names.
Parsed<ParameterDeclaration> parse_parameter(std::string_view text, base::SourceSpan span,
                                             Program& program, base::Diagnostics& errors);

}  // namespace formula
