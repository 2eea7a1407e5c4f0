// SPDX-License-Identifier: MIT
#include "formula/statements.h"

namespace formula {
namespace {

/// `param` is a word only in front of a declaration: `param = 2` and `param * x` use it as a name.
bool looks_like_parameter(std::string_view text, std::span<const Token> tokens) {
    if (tokens[0].kind != Token::Kind::name || tokens[0].text(text) != "param") return false;
    if (tokens.size() == 1 || tokens[1].starts_line) return true;
    return tokens[1].kind != Token::Kind::sign || tokens[1].text(text) == "[";
}

/// How many of the tokens stand on the first line, which goes on while a bracket is open.
std::size_t line_length(std::string_view text, std::span<const Token> tokens) {
    int open = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (i > 0 && open == 0 && tokens[i].starts_line) return i;
        if (tokens[i].kind != Token::Kind::sign) continue;
        const char sign = text[tokens[i].span.begin];
        if (sign == '(' || sign == '[') ++open;
        if (sign == ')' || sign == ']') --open;
    }
    return tokens.size();
}

}  // namespace

bool looks_like_definition(std::string_view text, std::span<const Token> tokens) {
    return tokens.size() > 1 && tokens[0].kind == Token::Kind::name && !tokens[1].starts_line &&
           tokens[1].text(text) == "=";
}

std::vector<StatementText> split(std::string_view text, std::span<const Token> tokens) {
    std::vector<StatementText> statements;
    while (!tokens.empty()) {
        const std::size_t length = line_length(text, tokens);
        StatementText statement{StatementText::Kind::result, tokens};
        if (looks_like_parameter(text, tokens)) {
            statement = {StatementText::Kind::parameter, tokens.first(length)};
        } else if (looks_like_definition(text, tokens) && length < tokens.size()) {
            statement = {StatementText::Kind::definition, tokens.first(length)};
        }
        statements.push_back(statement);
        tokens = tokens.subspan(statement.tokens.size());
    }
    return statements;
}

}  // namespace formula
