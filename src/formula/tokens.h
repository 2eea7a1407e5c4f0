// SPDX-License-Identifier: MIT
// The words and signs of a text. The grammar reads characters; this coarser view finds brackets and
// the ends of statements, and says what stood around a place where the grammar failed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"

namespace formula {

struct Token {
    enum class Kind : std::uint8_t { name, number, label, sign };

    Kind kind = Kind::sign;
    base::SourceSpan span;
    bool starts_line = false;  ///< the first of its line

    std::string_view text(std::string_view source) const {
        return source.substr(span.begin, span.end - span.begin);
    }
};

/// How many bytes at the front of the text are a name: letters of ASCII, digits and `_`, no digit
/// first. 0 if there is none.
std::size_t name_length(std::string_view text);

/// All tokens of a text that check_characters accepts, without blanks and comments. `<=` and `>=`
/// are one token, all other signs are one character. A label that is not closed ends with its line.
std::vector<Token> tokenize(std::string_view text);

/// Errors that need no grammar: labels that are not closed, signs of other languages such as `==`,
/// brackets without a partner, and more than max_brackets of them open at once.
base::Diagnostics check_tokens(std::string_view text, std::span<const Token> tokens);

}  // namespace formula
