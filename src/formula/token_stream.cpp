// SPDX-License-Identifier: MIT
#include "formula/token_stream.h"

#include <fmt/format.h>

#include <utility>

#include "formula/explain.h"

namespace formula {

base::SourceSpan TokenStream::here() const {
    if (!rest.empty()) return rest[0].span;
    const std::uint32_t end = before ? before->span.end : 0;
    return {end, end};
}

const Token& TokenStream::take() {
    before = &rest[0];
    rest = rest.subspan(1);
    return *before;
}

bool TokenStream::accept(std::string_view word) {
    if (!at(word)) return false;
    take();
    return true;
}

bool TokenStream::expect(std::string_view sign) {
    if (accept(sign)) return true;
    fail(fmt::format("expected '{}' after '{}'", sign, last()));
    return false;
}

void TokenStream::fail(std::string message) {
    errors.push_back(base::error(here(), std::move(message)));
}

void TokenStream::fail_behind_expression() {
    errors.push_back(explain(text, statement, {here().begin, "end"}));
}

std::optional<ExpressionId> read_front(TokenStream& stream, Extent extent, Within within) {
    const std::uint32_t place = stream.here().begin;
    const bool bracket = stream.rest.size() > 1 && stream.rest[1].text(stream.text) == "(";
    if (stream.rest.empty() ||
        (stream.at(Token::Kind::name) && !is_name(within, stream.next(), bracket))) {
        stream.errors.push_back(explain(stream.text, stream.statement, {place, "expression"}));
        return std::nullopt;
    }
    const std::size_t errors_before = stream.errors.size();
    const base::SourceSpan span{place, stream.rest.back().span.end};
    const Parsed<Front> parsed =
        parse_front(stream.text, span, extent, within, stream.program, stream.errors);
    if (const auto* failure = std::get_if<SyntaxError>(&parsed)) {
        stream.errors.push_back(explain(stream.text, stream.statement, *failure));
    }
    if (stream.errors.size() > errors_before) return std::nullopt;
    const Front& front = std::get<Front>(parsed);
    while (!stream.rest.empty() && stream.rest[0].span.begin < front.end) stream.take();
    return front.expression;
}

std::optional<std::string> read_label(TokenStream& stream, std::string_view after) {
    if (!stream.at(Token::Kind::label)) {
        stream.fail(fmt::format("expected a text in quotes after '{}'", after));
        return std::nullopt;
    }
    const std::string_view quoted = stream.take().text(stream.text);
    return std::string(quoted.substr(1, quoted.size() - 2));
}

}  // namespace formula
