// SPDX-License-Identifier: MIT
#include "formula/statements.h"

#include <algorithm>

namespace formula {
namespace {

/// `param` is a word only in front of a declaration: `param = 2` and `param * x` use it as a name.
bool looks_like_parameter(std::string_view text, std::span<const Token> tokens) {
    if (tokens[0].kind != Token::Kind::name || tokens[0].text(text) != "param") return false;
    if (tokens.size() == 1 || tokens[1].starts_line) return true;
    return tokens[1].kind != Token::Kind::sign || tokens[1].text(text) == "[";
}

bool is_sign(std::string_view text, const Token& token, std::string_view sign) {
    return token.kind == Token::Kind::sign && token.text(text) == sign;
}

/// +1 for a bracket that opens, -1 for one that closes.
int depth_change(std::string_view text, const Token& token) {
    if (token.kind != Token::Kind::sign) return 0;
    const char sign = text[token.span.begin];
    return sign == '(' || sign == '[' ? 1 : sign == ')' || sign == ']' ? -1 : 0;
}

/// How many of the tokens stand on the first line, which goes on while a bracket is open.
std::size_t line_length(std::string_view text, std::span<const Token> tokens) {
    int open = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (i > 0 && open == 0 && tokens[i].starts_line) return i;
        open += depth_change(text, tokens[i]);
    }
    return tokens.size();
}

/// The number of the tokens up to the first `:` outside of brackets, with it; 0 if there is none.
std::size_t colon_end(std::string_view text, std::span<const Token> tokens) {
    int open = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        open += depth_change(text, tokens[i]);
        if (open == 0 && is_sign(text, tokens[i], ":")) return i + 1;
    }
    return 0;
}

/// The names that `=` follows.
bool is_assigned(std::string_view text, std::span<const Token> tokens, std::string_view name) {
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (tokens[i].kind == Token::Kind::name && tokens[i].text(text) == name &&
            is_sign(text, tokens[i + 1], "=")) {
            return true;
        }
    }
    return false;
}

/// True if the brackets of a definition's front hold names, some with `= initial`.
bool has_plain_parameters(std::string_view text, std::span<const Token> front) {
    int open = 0;
    for (std::size_t i = 1; i + 1 < front.size(); ++i) {
        open += depth_change(text, front[i]);
        const bool starts = open == 1 && (i == 1 || is_sign(text, front[i], ","));
        if (!starts) continue;
        if (front[i + 1].kind != Token::Kind::name) return false;
        const std::string_view next = front[i + 2].text(text);
        if (next != "," && next != "=" && next != ")") return false;
    }
    return true;
}

/// True if a line that begins with this token goes on with the line above: it begins with a sign
/// that stands between operands, or it may do so.
enum class Continues { no, perhaps, yes };
Continues continues(std::string_view text, const Token& token) {
    if (token.kind != Token::Kind::sign) return Continues::no;
    const char sign = text[token.span.begin];
    if (sign == '+' || sign == '-') return Continues::perhaps;
    return std::string_view("*/^&|\\<>=").find(sign) == std::string_view::npos ? Continues::no
                                                                               : Continues::yes;
}

/// The statement's length if it is a definition, 0 if it is none.
std::size_t definition_length(std::string_view text, std::span<const Token> tokens) {
    const std::size_t front = definition_front(text, tokens);
    if (front == 0) return 0;
    const std::span<const Token> value = tokens.subspan(front);
    if (looks_like_iteration(text, value)) {
        const IterationText it = cut_iteration(text, value, indentation(text, tokens[0]));
        return front + it.head.size() + it.body.size();
    }
    const std::size_t length = line_length(text, tokens);
    if (length == tokens.size()) return 0;
    const Token& next = tokens[length];
    switch (continues(text, next)) {
        case Continues::no:
            return length;
        case Continues::perhaps:
            return has_plain_parameters(text, tokens.first(front)) &&
                           indentation(text, next) <= indentation(text, tokens[0])
                       ? length
                       : 0;
        case Continues::yes:
            return 0;
    }
    return 0;
}

}  // namespace

std::size_t indentation(std::string_view text, const Token& token) {
    const std::size_t newline = text.substr(0, token.span.begin).rfind('\n');
    std::size_t columns = 0;
    for (const char c : text.substr(newline + 1)) {
        if (c != ' ' && c != '\t') break;
        columns = c == ' ' ? columns + 1 : (columns / 8 + 1) * 8;
    }
    return columns;
}

std::size_t definition_front(std::string_view text, std::span<const Token> tokens) {
    if (tokens.size() < 2 || tokens[0].kind != Token::Kind::name || tokens[1].starts_line) return 0;
    if (is_sign(text, tokens[1], "=")) return 2;
    if (!is_sign(text, tokens[1], "(")) return 0;
    int open = 1;
    std::size_t i = 2;
    for (; i < tokens.size() && open > 0; ++i) open += depth_change(text, tokens[i]);
    if (i >= tokens.size() || tokens[i].starts_line) return 0;
    return is_sign(text, tokens[i], "=") ? i + 1 : 0;
}

bool looks_like_iteration(std::string_view text, std::span<const Token> tokens) {
    if (tokens.size() < 2 || tokens[0].kind != Token::Kind::name) return false;
    return tokens[0].text(text) == "iterate" && !tokens[1].starts_line &&
           tokens[1].kind != Token::Kind::sign;
}

IterationText cut_iteration(std::string_view text, std::span<const Token> tokens,
                            std::size_t outer) {
    std::size_t line = line_length(text, tokens);
    std::size_t head = colon_end(text, tokens.first(line));
    const auto goes_on = [&](const Token& token) {
        return token.text(text) == "for" || token.text(text) == "until" ||
               continues(text, token) == Continues::yes;
    };
    while (head == 0 && line < tokens.size() && goes_on(tokens[line])) {
        line += line_length(text, tokens.subspan(line));
        head = colon_end(text, tokens.first(line));
    }
    if (head == 0) head = line;
    if (head < line) return {tokens.first(head), tokens.subspan(head, line - head)};
    std::size_t end = line;
    const auto take_lines = [&](auto belongs) {
        while (end < tokens.size() && belongs(tokens.subspan(end))) {
            end += line_length(text, tokens.subspan(end));
        }
    };
    take_lines([&](auto next) { return indentation(text, next[0]) > outer; });
    if (end == line) {
        take_lines([&](auto next) {
            return definition_front(text, next) == 2 &&
                   is_assigned(text, tokens.first(head), next[0].text(text));
        });
    }
    return {tokens.first(head), tokens.subspan(line, end - line)};
}

std::vector<StatementText> split(std::string_view text, std::span<const Token> tokens) {
    std::vector<StatementText> statements;
    while (!tokens.empty()) {
        StatementText statement{StatementText::Kind::result, tokens};
        if (looks_like_parameter(text, tokens)) {
            statement = {StatementText::Kind::parameter, tokens.first(line_length(text, tokens))};
        } else if (const std::size_t length = definition_length(text, tokens)) {
            statement = {StatementText::Kind::definition, tokens.first(length)};
        }
        statements.push_back(statement);
        tokens = tokens.subspan(statement.tokens.size());
    }
    return statements;
}

}  // namespace formula
