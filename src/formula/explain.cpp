// SPDX-License-Identifier: MIT
#include "formula/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "formula/built_in.h"

namespace formula {
namespace {

/// What stands around the place of an error.
struct Scene {
    std::string_view text;
    const StatementText& statement;
    const Token* before = nullptr;  ///< the last token that was understood
    std::span<const Token> after;   ///< those that were not

    std::string_view last() const { return before ? before->text(text) : std::string_view(); }
    std::string_view next() const {
        return after.empty() ? std::string_view() : after[0].text(text);
    }
    bool in_parameter() const { return statement.kind == StatementText::Kind::parameter; }
};

bool ends_operand(const Scene& scene) {
    if (!scene.before) return false;
    return scene.before->kind != Token::Kind::sign || scene.last() == ")";
}

bool starts_operand(const Scene& scene) {
    if (scene.after.empty() || scene.after[0].kind == Token::Kind::label) return false;
    return scene.after[0].kind != Token::Kind::sign || scene.next() == "(";
}

bool is_relation(std::string_view sign) {
    return sign == "=" || sign == "<=" || sign == "<" || sign == ">=" || sign == ">";
}

std::string expected_expression(const Scene& scene) {
    std::string message = scene.before
                              ? fmt::format("expected an expression after '{}'", scene.last())
                              : fmt::format("expected an expression before '{}'", scene.next());
    if (scene.last() == "|" || scene.next() == "|") {
        message += "; '|' is a union, write abs(x) for an absolute value";
    } else if (scene.after.empty() && scene.statement.kind == StatementText::Kind::definition) {
        message += "; a definition ends with its line";
    }
    return message;
}

/// The word or number in front of the next sign or blank, for `write 'sin(2x)'`.
std::string_view next_word(const Scene& scene) {
    const std::string_view rest = scene.text.substr(scene.after[0].span.begin);
    const auto end = std::ranges::find_if(rest, [](char c) {
        return !((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                 c == '_' || c == '.');
    });
    return rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
}

/// `complete`: all that is open could have ended here.
std::string two_operands(const Scene& scene, bool complete) {
    if (scene.in_parameter() && (scene.next() == "in" || scene.next() == "step")) {
        return fmt::format(
            "'{}' is out of place; a parameter is written 'param a = 0.5 in [0, 2] "
            "step 0.1 \"label\"'",
            scene.next());
    }
    if (scene.after[0].starts_line) {
        if (complete && looks_like_definition(scene.text, scene.after)) {
            return fmt::format(
                "the expression has ended above; move the definition of '{}' up, or "
                "join two fields with '|' or '&'",
                scene.next());
        }
        if (complete && scene.next() == "param") {
            return "the expression has ended above; move the parameter up";
        }
        return fmt::format(
            "no operator between '{}' and '{}'; a product does not cross the end of "
            "a line, write '*'",
            scene.last(), scene.next());
    }
    if (scene.before->kind == Token::Kind::name && is_callable(scene.last())) {
        return fmt::format("'{0}' needs its argument in brackets; write '{0}({1})'", scene.last(),
                           next_word(scene));
    }
    return fmt::format("no operator between '{0}' and '{1}'; write '{0}*{1}' for a product",
                       scene.last(), scene.next());
}

std::string unexpected(const Scene& scene) {
    const std::string_view next = scene.next();
    if (scene.in_parameter()) {
        if (next == "[") return "expected 'in' before the range; write 'in [minimum, maximum]'";
        return fmt::format(
            "unexpected '{}'; a parameter is written 'param a = 0.5 in [0, 2] step "
            "0.1 \"label\"'",
            next);
    }
    if (is_relation(next)) return "comparisons cannot be chained; join two with '&'";
    if (next == ",") return "a ',' stands only between arguments in brackets";
    if (next == "[") return "'[' stands only before the range of a parameter; write '('";
    if (scene.after[0].kind == Token::Kind::label) {
        return "a label stands only at the end of a parameter's line";
    }
    return fmt::format("unexpected '{}'", next);
}

std::string describe(const Scene& scene, std::string_view expected) {
    const bool expects_sign = expected.starts_with('\'') && expected != "')'";
    if (expects_sign) return fmt::format("expected {} after '{}'", expected, scene.last());
    if (expected == "name") return fmt::format("expected a name after '{}'", scene.last());
    if (expected == "expression" || !ends_operand(scene)) return expected_expression(scene);
    if (starts_operand(scene)) return two_operands(scene, expected == "end");
    return unexpected(scene);
}

}  // namespace

base::Diagnostic explain(std::string_view text, const StatementText& statement,
                         const SyntaxError& error) {
    Scene scene{text, statement, nullptr, statement.tokens};
    while (!scene.after.empty() && scene.after[0].span.end <= error.place) {
        scene.before = &scene.after[0];
        scene.after = scene.after.subspan(1);
    }
    base::SourceSpan span;
    if (!scene.after.empty()) {
        span = scene.after[0].span;
    } else if (scene.before) {
        span = {scene.before->span.end, scene.before->span.end};
    }
    return base::error(span, describe(scene, error.expected));
}

}  // namespace formula
