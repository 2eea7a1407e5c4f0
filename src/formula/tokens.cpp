// SPDX-License-Identifier: MIT
#include "formula/tokens.h"

#include <fmt/format.h>

#include <algorithm>

#include "formula/limits.h"
#include "formula/number.h"

namespace formula {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t label_length(std::string_view text) {
    const std::size_t end = text.find_first_of("\"\n", 1);
    if (end == std::string_view::npos) return text.size();
    return text[end] == '"' ? end + 1 : end;
}

/// The token at the front of a text that starts with no blank and no comment.
Token front(std::string_view text) {
    Token token;
    std::size_t length = number_length(text);
    const std::size_t letters = name_length(text);
    if (length > 0) {
        token.kind = Token::Kind::number;
    } else if (letters > 0) {
        token.kind = Token::Kind::name;
        length = letters;
    } else if (text[0] == '"') {
        token.kind = Token::Kind::label;
        length = label_length(text);
    } else {
        length = text.starts_with("<=") || text.starts_with(">=") ? 2 : 1;
    }
    token.span.end = static_cast<std::uint32_t>(length);
    return token;
}

struct ForeignSign {
    std::string_view first, second;  ///< tokens that touch
    std::string_view message;
};
constexpr ForeignSign foreign_signs[] = {
    {"=", "=", "unknown operator '=='; write '='"},
    {"*", "*", "unknown operator '**'; write '^' for a power"},
    {"|", "|", "unknown operator '||'; write '|' for a union, or abs(x) for an absolute value"},
    {"&", "&", "unknown operator '&&'; write '&' for an intersection"},
    {"\\", "\\", "unknown operator '\\\\'; write '\\' for a difference"},
    {"/", "/", "unknown operator '//'; write '/' for a quotient, or '#' for a comment"},
    {"=", "<", "unknown operator '=<'; write '<='"},
    {"=", "<=", "unknown operator '=<='; write '<='"},
    {"=", ">", "unknown operator '=>'; write '>='"},
    {"=", ">=", "unknown operator '=>='; write '>='"},
    {"<", ">", "unknown operator '<>'; compare with '=', '<=' or '>='"},
    {"<=", "=", "unknown operator '<=='; write '<='"},
    {">=", "=", "unknown operator '>=='; write '>='"},
    {"<", "<", "unknown operator '<<'; write '<'"},
    {">", ">", "unknown operator '>>'; write '>'"},
};

void check_signs(std::string_view text, std::span<const Token> tokens, base::Diagnostics& errors) {
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const Token& token = tokens[i];
        if (token.kind == Token::Kind::label &&
            (token.span.end - token.span.begin < 2 || text[token.span.end - 1] != '"')) {
            errors.push_back(base::error({token.span.begin, token.span.begin + 1},
                                         "the label is not closed; write '\"' at its end"));
        }
        if (token.kind != Token::Kind::sign || i + 1 == tokens.size()) continue;
        const Token& next = tokens[i + 1];
        if (next.span.begin != token.span.end) continue;
        for (const ForeignSign& foreign : foreign_signs) {
            if (foreign.first == token.text(text) && foreign.second == next.text(text)) {
                errors.push_back(
                    base::error(base::cover(token.span, next.span), std::string(foreign.message)));
                ++i;
                break;
            }
        }
    }
}

void check_brackets(std::string_view text, std::span<const Token> tokens,
                    base::Diagnostics& errors) {
    std::vector<const Token*> open;
    for (const Token& token : tokens) {
        if (token.kind != Token::Kind::sign) continue;
        const char sign = text[token.span.begin];
        if (sign == '(' || sign == '[') {
            open.push_back(&token);
            if (open.size() > max_brackets) {
                errors.push_back(base::error(
                    token.span, fmt::format("more than {} brackets are open here; give parts of "
                                            "the formula names in definitions",
                                            max_brackets)));
                return;
            }
        } else if (sign == ')' || sign == ']') {
            if (open.empty()) {
                errors.push_back(base::error(
                    token.span,
                    fmt::format("no bracket is open that this '{}' could close", sign)));
                return;
            }
            const char opened = text[open.back()->span.begin];
            const char closing = opened == '(' ? ')' : ']';
            if (sign != closing) {
                errors.push_back(base::error(
                    token.span,
                    fmt::format("'{}' cannot close a '{}'; write '{}'", sign, opened, closing)));
                return;
            }
            open.pop_back();
        }
    }
    if (!open.empty()) {
        const char opened = text[open.back()->span.begin];
        errors.push_back(
            base::error(open.back()->span, fmt::format("this '{}' is never closed", opened)));
    }
}

}  // namespace

std::size_t name_length(std::string_view text) {
    if (text.empty() || is_digit(text[0])) return 0;
    const auto end = std::find_if(text.begin(), text.end(),
                                  [](char c) { return !is_letter(c) && !is_digit(c); });
    return static_cast<std::size_t>(end - text.begin());
}

std::vector<Token> tokenize(std::string_view text) {
    std::vector<Token> tokens;
    bool starts_line = true;
    std::size_t at = 0;
    while (at < text.size()) {
        const char c = text[at];
        if (c == '\n') {
            starts_line = true;
            ++at;
        } else if (c == ' ' || c == '\t' || c == '\r') {
            ++at;
        } else if (c == '#') {
            at = std::min(text.find('\n', at), text.size());
        } else {
            Token token = front(text.substr(at));
            token.starts_line = starts_line;
            token.span.begin = static_cast<std::uint32_t>(at);
            token.span.end += token.span.begin;
            tokens.push_back(token);
            starts_line = false;
            at = token.span.end;
        }
    }
    return tokens;
}

base::Diagnostics check_tokens(std::string_view text, std::span<const Token> tokens) {
    base::Diagnostics errors;
    check_signs(text, tokens, errors);
    check_brackets(text, tokens, errors);
    return errors;
}

}  // namespace formula
