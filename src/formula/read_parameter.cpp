// SPDX-License-Identifier: MIT
// Reads the declaration of a parameter.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "formula/suggest.h"
#include "formula/token_stream.h"

namespace formula {
namespace {

constexpr std::string_view form =
    "a parameter is written 'param a = 0.5 in [0, 2] step 0.1 \"label\"'";

/// `on` or `off` as the whole value: nothing follows but modifiers.
bool at_toggle(const TokenStream& stream) {
    if (!stream.at("on") && !stream.at("off")) return false;
    return stream.rest.size() == 1 || stream.rest[1].kind != Token::Kind::sign;
}

bool read_name(TokenStream& stream, ParameterDeclaration& parameter) {
    stream.take();
    if (!stream.at(Token::Kind::name) || stream.at("in") || stream.at("step")) {
        stream.fail("expected a name after 'param'");
        return false;
    }
    const Token& name = stream.take();
    parameter.name = name.text(stream.text);
    parameter.span = parameter.type_span = name.span;
    return stream.expect("=");
}

/// Takes `= 1`; of a choice returns the label.
bool read_initial(TokenStream& stream, ParameterDeclaration& parameter,
                  std::optional<std::string>& choice) {
    const base::SourceSpan span = stream.here();
    if (stream.at(Token::Kind::label)) {
        parameter.type = ParameterType::choice;
        choice = read_label(stream, "=");
        parameter.initial = stream.program.add(Number{0}, span);
        return true;
    }
    if (at_toggle(stream)) {
        const bool on = stream.take().text(stream.text) == "on";
        parameter.type = ParameterType::toggle;
        parameter.type_span = span;
        parameter.initial = stream.program.add(Number{on ? 1.0 : 0.0}, span);
        return true;
    }
    const auto value = read_sum(stream, Within::parameter);
    if (!value) return false;
    parameter.initial = *value;
    return true;
}

/// Takes `["a", "b"]` and finds the initial one.
bool read_choices(TokenStream& stream, ParameterDeclaration& parameter,
                  const std::string& initial) {
    if (!stream.expect("[")) return false;
    do {
        const base::SourceSpan span = stream.here();
        std::optional<std::string> label = read_label(stream, stream.last());
        if (!label) return false;
        if (std::ranges::find(parameter.choices, *label) != parameter.choices.end()) {
            stream.errors.push_back(
                base::error(span, fmt::format("the choice \"{}\" is there twice", *label)));
            return false;
        }
        parameter.choices.push_back(*std::move(label));
    } while (stream.accept(","));
    if (!stream.expect("]")) return false;
    Expression& value = stream.program.expressions[index(parameter.initial)];
    const auto found = std::ranges::find(parameter.choices, initial);
    if (found == parameter.choices.end()) {
        const std::vector<std::string_view> known(parameter.choices.begin(),
                                                  parameter.choices.end());
        const std::string_view meant = nearest(initial, known);
        stream.errors.push_back(base::error(
            value.span,
            fmt::format("\"{}\" is none of the choices{}", initial,
                        meant.empty() ? "" : fmt::format("; did you mean \"{}\"?", meant))));
        return false;
    }
    value.node = Number{static_cast<double>(found - parameter.choices.begin())};
    return true;
}

/// Takes `[0, 1]`.
bool read_range(TokenStream& stream, ParameterDeclaration& parameter) {
    if (!stream.expect("[")) return false;
    if (stream.at(Token::Kind::label)) {
        stream.fail("these are choices, so the value is one of them in quotes");
        return false;
    }
    const auto minimum = read_sum(stream, Within::parameter);
    if (!minimum || !stream.expect(",")) return false;
    const auto maximum = read_sum(stream, Within::parameter);
    if (!maximum || !stream.expect("]")) return false;
    parameter.range = {*minimum, *maximum};
    return true;
}

/// Takes the value and `in [...]`.
bool read_values(TokenStream& stream, ParameterDeclaration& parameter) {
    std::optional<std::string> choice;
    if (!read_initial(stream, parameter, choice)) return false;
    if (choice && !stream.at("in")) {
        stream.fail(fmt::format("expected the choices after {}; write 'in [{}, \"...\"]'",
                                stream.last(), stream.last()));
        return false;
    }
    if (parameter.type == ParameterType::toggle && stream.at("in")) {
        stream.fail("a parameter that is on or off has no range");
        return false;
    }
    if (!stream.accept("in")) return true;
    return choice ? read_choices(stream, parameter, *choice) : read_range(stream, parameter);
}

bool read_type(TokenStream& stream, ParameterDeclaration& parameter, ParameterType type) {
    if (parameter.type == ParameterType::choice || parameter.type == ParameterType::toggle) {
        stream.fail(fmt::format("a parameter that is a choice, on or off cannot be '{}' too",
                                stream.next()));
        return false;
    }
    if (parameter.type != ParameterType::real) {
        stream.fail(
            fmt::format("'{}' is the second type; a parameter has only one", stream.next()));
        return false;
    }
    parameter.type = type;
    parameter.type_span = stream.take().span;
    return true;
}

/// Takes a text into a place where none is yet.
bool read_text(TokenStream& stream, std::optional<std::string>& text, std::string_view what) {
    if (text) {
        stream.fail(fmt::format("the parameter has {} already", what));
        return false;
    }
    if (!stream.at(Token::Kind::label)) stream.take();
    text = read_label(stream, stream.last());
    return text.has_value();
}

bool read_step(TokenStream& stream, ParameterDeclaration& parameter) {
    if (parameter.step) {
        stream.fail("the parameter has a step already");
        return false;
    }
    if (parameter.type == ParameterType::choice || parameter.type == ParameterType::toggle) {
        stream.fail("a parameter that is a choice, on or off has no step");
        return false;
    }
    stream.take();
    parameter.step = read_sum(stream, Within::parameter);
    return parameter.step.has_value();
}

/// Reports what is no modifier. `behind_value`: it could be meant as a part of an expression.
void fail_at_modifier(TokenStream& stream, bool behind_value) {
    const std::string_view next = stream.next();
    if (stream.at("in")) {
        stream.fail("'in' is out of place; the range stands next to the value");
    } else if (stream.at("[")) {
        stream.fail("expected 'in' before the range; write 'in [minimum, maximum]'");
    } else if (stream.at(",")) {
        stream.fail("a ',' stands only in brackets; write a vector as '(1, 2, 3)'");
    } else if (stream.at(Token::Kind::name) && resembles_modifier(Within::parameter, next)) {
        stream.fail(fmt::format("unknown word '{}' behind the value; did you mean '{}'?", next,
                                nearest(next, modifiers())));
    } else if (stream.at(Token::Kind::sign) && !stream.at("(")) {
        stream.fail(fmt::format("unexpected '{}'; {}", next, form));
    } else if (behind_value) {
        stream.fail_behind_expression();
    } else {
        stream.fail(fmt::format("unknown word '{}' behind the value; it is one of {}", next,
                                fmt::join(modifiers(), ", ")));
    }
}

bool read_modifier(TokenStream& stream, ParameterDeclaration& parameter, bool behind_value) {
    if (stream.at(Token::Kind::label)) return read_text(stream, parameter.label, "a label");
    if (stream.at("group")) return read_text(stream, parameter.group, "a group");
    if (stream.at("tooltip")) return read_text(stream, parameter.tooltip, "a tooltip");
    if (stream.at("step")) return read_step(stream, parameter);
    for (const ParameterType type : {ParameterType::integer, ParameterType::logarithmic,
                                     ParameterType::angle, ParameterType::colour}) {
        if (stream.at(spelling(type))) return read_type(stream, parameter, type);
    }
    fail_at_modifier(stream, behind_value);
    return false;
}

}  // namespace

std::optional<ParameterDeclaration> read_parameter(TokenStream& stream) {
    ParameterDeclaration parameter;
    if (!read_name(stream, parameter) || !read_values(stream, parameter)) return std::nullopt;
    bool behind_value = !parameter.range && parameter.type == ParameterType::real;
    while (!stream.rest.empty()) {
        const bool step = stream.at("step");
        if (!read_modifier(stream, parameter, behind_value)) return std::nullopt;
        behind_value = step;
    }
    return parameter;
}

}  // namespace formula
