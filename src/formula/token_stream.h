// SPDX-License-Identifier: MIT
// A statement that is read token by token, its expressions by the grammar. Internal to the library.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/diagnostic.h"
#include "formula/ast.h"
#include "formula/grammar.h"
#include "formula/statements.h"
#include "formula/words.h"

namespace formula {

/// What is left of a statement. Whoever finds an error in it reports that and stops reading.
struct TokenStream {
    std::string_view text;
    Program& program;
    base::Diagnostics& errors;
    StatementText statement;
    std::span<const Token> rest = statement.tokens;
    const Token* before = nullptr;  ///< the last token that was taken

    /// The next token's text; empty at the end.
    std::string_view next() const { return rest.empty() ? std::string_view() : rest[0].text(text); }
    std::string_view last() const { return before ? before->text(text) : std::string_view(); }
    bool at(Token::Kind kind) const { return !rest.empty() && rest[0].kind == kind; }
    /// True before this sign or word.
    bool at(std::string_view word) const { return !at(Token::Kind::label) && next() == word; }
    /// The next token's place; the place behind the last one at the end.
    base::SourceSpan here() const;

    /// Takes the next token, which there is.
    const Token& take();
    /// Takes the next token if it is this sign or word.
    bool accept(std::string_view word);
    /// The same, and reports its absence.
    bool expect(std::string_view sign);

    /// Reports an error at the next token.
    void fail(std::string message);
    /// Reports that the next token does not fit behind an expression.
    void fail_behind_expression();
};

/// Takes one expression; nothing if it has an error.
std::optional<ExpressionId> read_front(TokenStream& stream, Extent extent, Within within);
inline std::optional<ExpressionId> read_sum(TokenStream& stream, Within within) {
    return read_front(stream, Extent::sum, within);
}

/// Takes a label and returns what is between its quotes; `after` what it must stand is for the
/// error.
std::optional<std::string> read_label(TokenStream& stream, std::string_view after);

/// Takes `param ...`, the whole statement.
std::optional<ParameterDeclaration> read_parameter(TokenStream& stream);

/// Takes `(a, b = 1)` behind the name of a function.
std::optional<std::vector<FunctionParameter>> read_function_parameters(TokenStream& stream);

/// Takes an iteration, to the end of the statement; Broken if there is an error.
ExpressionId read_iteration(TokenStream& stream);

}  // namespace formula
