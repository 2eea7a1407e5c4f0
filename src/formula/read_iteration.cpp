// SPDX-License-Identifier: MIT
// Reads an iteration: its head, then its body part by part, each with its own errors.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "formula/token_stream.h"

namespace formula {
namespace {

constexpr std::string_view example = "q = q^2 + c";

/// Words whose value the body gives after the last turn.
bool is_result(std::string_view name) { return name == "distance" || name == "colour"; }

/// Takes `q = start`.
bool read_state(TokenStream& head, Iterate& iterate) {
    if (!head.at(Token::Kind::name) || !is_name(Within::iteration, head.next(), false)) {
        head.fail(fmt::format("expected a name after '{}'", head.last()));
        return false;
    }
    const Token& name = head.take();
    const std::string text(name.text(head.text));
    const bool twice =
        std::ranges::find(iterate.state, text, &Assignment::name) != iterate.state.end();
    if (twice || is_result(text)) {
        head.errors.push_back(base::error(
            name.span, twice ? fmt::format("'{}' has an initial value already", text)
                             : fmt::format("'{}' is given in the body, after the last turn; choose "
                                           "another name",
                                           text)));
        return false;
    }
    if (!head.expect("=")) return false;
    const auto value = read_sum(head, Within::iteration);
    if (!value) return false;
    if (head.at("=")) {
        head.fail(fmt::format("'{}' has an initial value already", text));
        return false;
    }
    iterate.state.push_back({text, name.span, *value});
    return true;
}

/// Takes the condition behind `until`.
bool read_until(TokenStream& head, Iterate& iterate) {
    iterate.until = read_front(head, Extent::whole, Within::iteration);
    if (!iterate.until) return false;
    const ExpressionNode& node = head.program[*iterate.until].node;
    if (std::holds_alternative<Comparison>(node) || std::holds_alternative<Intersection>(node) ||
        std::holds_alternative<Union>(node)) {
        return true;
    }
    head.fail("expected a comparison after 'until', such as 'until length(q) > 4'");
    return false;
}

/// True if the next token cannot belong to the expression before it.
bool behind_part(const TokenStream& head) {
    return head.rest.empty() || head.at(":") || head.at("for") || head.at("until");
}

bool read_head(TokenStream& head, Iterate& iterate) {
    head.take();
    do {
        if (!read_state(head, iterate)) return false;
    } while (head.accept(","));
    if (!head.accept("for")) {
        if (behind_part(head)) {
            head.fail("expected 'for' and the number of turns, such as 'for 12'");
        } else {
            head.fail_behind_expression();
        }
        return false;
    }
    const auto limit = read_sum(head, Within::iteration);
    if (!limit) return false;
    iterate.limit = *limit;
    if (head.accept("until") && !read_until(head, iterate)) return false;
    if (head.accept(":")) return true;
    if (head.rest.empty()) {
        head.fail(fmt::format("expected ':' and the body after '{}'", head.last()));
    } else {
        head.fail_behind_expression();
    }
    return false;
}

/// Takes `name = value`, a whole part of the body.
void read_assignment(TokenStream& part, Iterate& iterate) {
    const bool assigns = part.at(Token::Kind::name) && part.rest.size() > 1 &&
                         part.rest[1].kind == Token::Kind::sign &&
                         part.rest[1].text(part.text) == "=";
    if (!assigns) {
        part.fail(part.at(Token::Kind::sign)
                      ? std::string("expected an assignment; one that takes several lines needs "
                                    "brackets around its value")
                      : fmt::format("expected an assignment such as '{}'", example));
        return;
    }
    const Token& name = part.take();
    part.take();
    const std::string text(name.text(part.text));
    if (looks_like_iteration(part.text, part.rest)) {
        part.fail("an iteration cannot stand in another; define it as a function above");
        return;
    }
    const base::SourceSpan whole = part.statement.span();
    auto value = read_sum(part, Within::statement);
    if (value && !part.rest.empty()) {
        part.fail_behind_expression();
        value.reset();
    }
    const ExpressionId id = value ? *value : part.program.add(Broken{}, whole);
    if (!is_result(text)) {
        iterate.body.push_back({text, name.span, id});
        return;
    }
    std::optional<ExpressionId>& result = text == "distance" ? iterate.distance : iterate.colour;
    if (result) {
        part.errors.push_back(
            base::error(name.span, fmt::format("'{}' has a value already", text)));
    }
    result = id;
}

/// How many of the tokens are the first part of a body: up to `;` or the end of the line.
std::size_t part_length(std::string_view text, std::span<const Token> tokens) {
    int open = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const std::string_view token = tokens[i].text(text);
        if (open == 0 && (token == ";" || (i > 0 && tokens[i].starts_line))) return i;
        if (token == "(" || token == "[") ++open;
        if (token == ")" || token == "]") --open;
    }
    return tokens.size();
}

void read_assignments(TokenStream& stream, std::span<const Token> body, Iterate& iterate) {
    while (!body.empty()) {
        const std::size_t length = part_length(stream.text, body);
        if (length > 0) {
            TokenStream part{stream.text,
                             stream.program,
                             stream.errors,
                             {StatementText::Kind::assignment, body.first(length)}};
            read_assignment(part, iterate);
        }
        const bool separated = length < body.size() && body[length].text(stream.text) == ";";
        body = body.subspan(separated ? length + 1 : length);
    }
}

/// Takes the body; reports one that is missing or stands where it does not belong.
void read_body(TokenStream& stream, const IterationText& cut, std::size_t outer, Iterate& iterate) {
    const std::span<const Token> body = cut.body;
    if (!body.empty() && body[0].starts_line && indentation(stream.text, body[0]) <= outer) {
        stream.errors.push_back(
            base::error(body[0].span,
                        "the body of an iteration must be indented more than the line that it "
                        "begins on"));
        return;
    }
    const std::size_t errors_before = stream.errors.size();
    read_assignments(stream, body, iterate);
    const bool empty = iterate.body.empty() && !iterate.distance && !iterate.colour;
    if (!empty || stream.errors.size() > errors_before) return;
    const std::uint32_t end = cut.head.back().span.end;
    stream.errors.push_back(base::error(
        {end, end}, fmt::format("the iteration has no body; write its assignments such as '{}' "
                                "below, indented",
                                example)));
}

/// Reports what stands below the body.
void check_end(TokenStream& stream) {
    if (stream.rest.empty()) return;
    if (stream.at(Token::Kind::sign)) {
        stream.fail(
            "the iteration has ended above; give it a name in a definition to join it with other "
            "fields");
    } else {
        stream.fail_behind_expression();
    }
}

}  // namespace

ExpressionId read_iteration(TokenStream& stream) {
    const std::size_t errors_before = stream.errors.size();
    const std::size_t outer = indentation(stream.text, stream.statement.tokens[0]);
    const IterationText cut = cut_iteration(stream.text, stream.rest, outer);
    const std::uint32_t begin = stream.here().begin;
    TokenStream head{stream.text,
                     stream.program,
                     stream.errors,
                     {StatementText::Kind::iteration_head, cut.head}};
    Iterate iterate;
    const bool good = read_head(head, iterate);
    if (good || !cut.body.empty()) read_body(stream, cut, outer, iterate);
    for (std::size_t taken = cut.head.size() + cut.body.size(); taken > 0; --taken) stream.take();
    const base::SourceSpan span{begin, stream.before->span.end};
    check_end(stream);
    if (stream.errors.size() > errors_before) return stream.program.add(Broken{}, span);
    return stream.program.add(std::move(iterate), span);
}

}  // namespace formula
