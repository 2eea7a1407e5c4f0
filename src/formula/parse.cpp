// SPDX-License-Identifier: MIT
#include "formula/parse.h"

#include <fmt/format.h>

#include <cassert>
#include <utility>

#include "formula/characters.h"
#include "formula/explain.h"
#include "formula/grammar.h"
#include "formula/limits.h"
#include "formula/report.h"
#include "formula/statements.h"
#include "formula/token_stream.h"

namespace formula {
namespace {

/// Parses statement by statement into one program.
struct Reader {
    std::string_view text;
    Program program;
    base::Diagnostics errors;

    TokenStream stream(const StatementText& statement) {
        return {text, program, errors, statement};
    }

    /// Reads what is left of a statement as its value.
    ExpressionId value(TokenStream& stream) {
        if (looks_like_iteration(text, stream.rest)) return read_iteration(stream);
        const std::uint32_t begin = stream.before ? stream.before->span.end : stream.here().begin;
        const base::SourceSpan span{begin, stream.statement.span().end};
        const std::size_t errors_before = errors.size();
        const Parsed<ExpressionId> parsed = parse_expression(text, span, program, errors);
        if (const auto* failure = std::get_if<SyntaxError>(&parsed)) {
            errors.push_back(explain(text, stream.statement, *failure));
        }
        if (errors.size() > errors_before) return program.add(Broken{}, span);
        return std::get<ExpressionId>(parsed);
    }

    void add_definition(const StatementText& statement) {
        TokenStream rest = stream(statement);
        const Token& name = rest.take();
        Definition definition{std::string(name.text(text)), name.span, {}, std::nullopt};
        const bool function = rest.at("(");
        if (function) definition.parameters = read_function_parameters(rest);
        const bool good = !function || definition.parameters;
        definition.value =
            good && rest.expect("=") ? value(rest) : program.add(Broken{}, statement.span());
        program.statements.push_back(std::move(definition));
    }

    void add_parameter(const StatementText& statement) {
        TokenStream rest = stream(statement);
        auto parameter = read_parameter(rest);
        if (!parameter) {
            parameter.emplace();
            if (statement.tokens.size() > 1 && statement.tokens[1].kind == Token::Kind::name) {
                parameter->name = statement.tokens[1].text(text);
                parameter->span = statement.tokens[1].span;
            }
            parameter->initial = program.add(Broken{}, statement.span());
        }
        program.statements.push_back(*std::move(parameter));
    }

    void add(const StatementText& statement) {
        switch (statement.kind) {
            case StatementText::Kind::definition:
                add_definition(statement);
                break;
            case StatementText::Kind::parameter:
                add_parameter(statement);
                break;
            case StatementText::Kind::result: {
                TokenStream rest = stream(statement);
                program.result = value(rest);
                break;
            }
            case StatementText::Kind::iteration_head:
            case StatementText::Kind::assignment:
                assert(false);
                break;
        }
    }

    void check_result(std::span<const StatementText> statements) {
        if (statements.empty()) {
            errors.push_back(base::error(
                {0, 0}, "the formula is empty; type an equation such as x^2 + y^2 + z^2 = 1"));
        } else if (statements.back().kind != StatementText::Kind::result) {
            const std::uint32_t end = statements.back().span().end;
            errors.push_back(base::error(
                {end, end},
                "the formula has nothing to show; type an equation such as x^2 + y^2 + z^2 = 1 "
                "below its parameters"));
            program.result = program.add(Broken{}, {end, end});
        }
    }
};

}  // namespace

Reading read(std::string_view text) {
    if (text.size() > max_text_bytes) {
        return {std::nullopt,
                {base::error({max_text_bytes, max_text_bytes},
                             fmt::format("the formula is longer than {} bytes", max_text_bytes))}};
    }
    base::Diagnostics errors = check_characters(text);
    if (!errors.empty()) return {std::nullopt, std::move(errors)};
    const std::vector<Token> tokens = tokenize(text);
    errors = check_tokens(text, tokens);
    if (!errors.empty()) return {std::nullopt, in_order(std::move(errors))};
    Reader reader{text, {}, {}};
    const std::vector<StatementText> statements = split(text, tokens);
    for (const StatementText& statement : statements) reader.add(statement);
    reader.check_result(statements);
    if (statements.empty()) return {std::nullopt, std::move(reader.errors)};
    return {std::move(reader.program), in_order(std::move(reader.errors))};
}

base::Result<Program> parse(std::string_view text) {
    Reading reading = read(text);
    if (!reading.errors.empty()) return std::move(reading.errors);
    return *std::move(reading.program);
}

}  // namespace formula
