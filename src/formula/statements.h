// SPDX-License-Identifier: MIT
// Cuts a text into its statements: definitions and parameters, one a line, then one expression.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "formula/tokens.h"

namespace formula {

struct StatementText {
    enum class Kind { definition, parameter, result };

    Kind kind = Kind::result;
    std::span<const Token> tokens;  ///< at least one

    base::SourceSpan span() const { return {tokens.front().span.begin, tokens.back().span.end}; }
};

/// The statements in their order. A line that starts with `param` and is no use of that name is a
/// parameter; a line `name = ...` is a definition if anything follows it; the first line that is
/// neither begins the result, which takes the rest. A line goes on while a bracket is open. If the
/// text has no result, no statement of that kind is in the list. The tokens have passed
/// check_tokens.
std::vector<StatementText> split(std::string_view text, std::span<const Token> tokens);

/// True if a definition could start at the first of these tokens: `name =`.
bool looks_like_definition(std::string_view text, std::span<const Token> tokens);

}  // namespace formula
