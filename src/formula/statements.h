// SPDX-License-Identifier: MIT
// Cuts a text into its statements: definitions and parameters, then one expression.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "formula/tokens.h"

namespace formula {

struct StatementText {
    /// The last two are parts of an iteration: `split` gives none.
    enum class Kind { definition, parameter, result, iteration_head, assignment };

    Kind kind = Kind::result;
    std::span<const Token> tokens;  ///< at least one

    base::SourceSpan span() const { return {tokens.front().span.begin, tokens.back().span.end}; }
};

/// The statements in their order. The tokens have passed check_tokens.
/// - A line that starts with `param` and is no use of that name is a parameter.
/// - A line `name = ...` or `name(a, b = ...) = ...` is a definition if a line follows it that can
///   begin a statement, or if its value is an iteration: not before a line that begins with a sign
///   that stands between operands. A line that begins with `+` or `-` can begin a statement if it
///   is not indented more than the definition.
/// - The first line that is neither begins the result, which takes the rest. If the text has no
///   result, no statement of that kind is in the list.
/// A line goes on while a bracket is open. An iteration goes on to the end of its body.
std::vector<StatementText> split(std::string_view text, std::span<const Token> tokens);

/// How many of the tokens are `name =` or `name(...) =`, the front of a definition; 0 if they are
/// something else.
std::size_t definition_front(std::string_view text, std::span<const Token> tokens);

/// True if the tokens start an iteration rather than use the name `iterate`.
bool looks_like_iteration(std::string_view text, std::span<const Token> tokens);

/// An iteration, cut into what stands before its body and the body.
struct IterationText {
    std::span<const Token> head;  ///< from `iterate` to `:`, or to the end of the line without one
    std::span<const Token> body;
};

/// Cuts the iteration that these tokens start. Its head goes on with lines that begin with `for` or
/// `until`. Its body is the rest of the head's last line or, if there is nothing, all next lines
/// that are indented more than `indentation`. If there are none of these either, it is the next
/// lines that assign to what the head names, so that the body can be told to be indented.
IterationText cut_iteration(std::string_view text, std::span<const Token> tokens,
                            std::size_t indentation);

/// How far the line of a token is indented, in columns; a tab goes to the next multiple of 8.
std::size_t indentation(std::string_view text, const Token& token);

}  // namespace formula
