// SPDX-License-Identifier: MIT
// The grammar. Its source is the only file that includes Boost.Spirit X3.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "base/diagnostic.h"
#include "formula/ast.h"
#include "formula/words.h"

namespace formula {

/// Where a text leaves the grammar. `expected` is what had to stand there: "expression",
/// "component", a sign in quotes, or "end".
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

/// An expression at the front of a text.
struct Front {
    ExpressionId expression{};
    std::uint32_t end = 0;  ///< the place in the text behind it
};

/// Whether an expression may compare and join outside of brackets, or is a sum, which does not.
enum class Extent { sum, whole };

/// Parses as much of the span from its beginning as is one expression. What `within` calls a
/// keyword ends it.
Parsed<Front> parse_front(std::string_view text, base::SourceSpan span, Extent extent,
                          Within within, Program& program, base::Diagnostics& errors);

}  // namespace formula
