// SPDX-License-Identifier: MIT
#include "formula/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "formula/built_in.h"

namespace formula {
namespace {

using Kind = StatementText::Kind;

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
    bool in(StatementText::Kind kind) const { return statement.kind == kind; }
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
    } else if (scene.after.empty() && scene.in(Kind::definition)) {
        message += "; a definition ends with its line";
    } else if (scene.after.empty() && scene.in(Kind::assignment)) {
        message += "; an assignment ends with its line";
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
    if (scene.after[0].starts_line) {
        if (complete && definition_front(scene.text, scene.after)) {
            return fmt::format(
                "the expression has ended above; move the definition of '{}' up, or "
                "join two fields with '|' or '&'",
                scene.next());
        }
        if (complete && scene.next() == "param") {
            return "the expression has ended above; move the parameter up";
        }
        if (complete && scene.in(Kind::result) &&
            definition_front(scene.text, scene.statement.tokens)) {
            return "a definition ends with its line; put brackets around a longer value";
        }
        return fmt::format(
            "no operator between '{}' and '{}'; a product does not cross the end of "
            "a line, write '*'",
            scene.last(), scene.next());
    }
    if (scene.last() == "iterate") {
        return "an iteration stands alone; give it a name in a definition and use that";
    }
    if (scene.before->kind == Token::Kind::name && is_callable(scene.last())) {
        return fmt::format("'{0}' needs its argument in brackets; write '{0}({1})'", scene.last(),
                           next_word(scene));
    }
    return fmt::format("no operator between '{0}' and '{1}'; write '{0}*{1}' for a product",
                       scene.last(), scene.next());
}

std::string unexpected_in_assignment(std::string_view next) {
    if (next == "=") return "an assignment has one '='; put ';' or a new line before the next one";
    if (is_relation(next)) return "a comparison is no value; choose between values with 'if'";
    if (next == "|" || next == "&" || next == "\\") {
        return "fields cannot be joined in an iteration; join its result";
    }
    return fmt::format("unexpected '{}'; an assignment ends with ';' or its line", next);
}

std::string unexpected(const Scene& scene) {
    const std::string_view next = scene.next();
    if (scene.in(Kind::assignment)) return unexpected_in_assignment(next);
    if (scene.in(Kind::iteration_head) && !is_relation(next)) {
        return fmt::format(
            "unexpected '{}'; an iteration begins like 'iterate q = p for 12 until length(q) > 4:'",
            next);
    }
    if (is_relation(next)) return "comparisons cannot be chained; join two with '&'";
    if (next == ",") return "a ',' stands only between arguments in brackets";
    if (next == "[") return "'[' stands only before the range of a parameter; write '('";
    if (scene.after[0].kind == Token::Kind::label) {
        return "a label stands only at the end of a parameter's line";
    }
    if (next == ";") return "a ';' stands only in an iteration; write each definition on its line";
    if (next == ":") return "a ':' stands only before the body of an iteration";
    if (next == ".") return "a '.' before letters stands only next to a name or a ')'";
    return fmt::format("unexpected '{}'", next);
}

std::string describe(const Scene& scene, std::string_view expected) {
    const bool expects_sign = expected.starts_with('\'') && expected != "')'";
    if (expects_sign) return fmt::format("expected {} after '{}'", expected, scene.last());
    if (expected == "component") {
        return "expected a component after '.', as in 'p.x'";
    }
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
