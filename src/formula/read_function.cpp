// SPDX-License-Identifier: MIT
// Reads what a function that the user defines is called with.
#include <fmt/format.h>

#include <algorithm>

#include "formula/token_stream.h"

namespace formula {
namespace {

/// Takes `a` or `a = 1`.
std::optional<FunctionParameter> read_one(TokenStream& stream) {
    if (!stream.at(Token::Kind::name)) {
        stream.fail(
            "expected a name; a function is defined by the names of its parameters, as in "
            "'f(a, b = 1) = a + b'");
        return std::nullopt;
    }
    const Token& name = stream.take();
    FunctionParameter parameter{std::string(name.text(stream.text)), name.span, std::nullopt};
    if (stream.accept("=")) {
        parameter.initial = read_sum(stream, Within::statement);
        if (!parameter.initial) return std::nullopt;
        if (stream.at("=")) {
            stream.fail(
                fmt::format("the parameter '{}' has an initial value already", parameter.name));
            return std::nullopt;
        }
    }
    return parameter;
}

}  // namespace

std::optional<std::vector<FunctionParameter>> read_function_parameters(TokenStream& stream) {
    std::vector<FunctionParameter> parameters;
    const std::string_view function = stream.last();
    if (!stream.expect("(")) return std::nullopt;
    if (stream.at(")")) {
        stream.fail(
            fmt::format("a function has at least one parameter; write '{} = ...'", function));
        return std::nullopt;
    }
    do {
        std::optional<FunctionParameter> parameter = read_one(stream);
        if (!parameter) return std::nullopt;
        if (std::ranges::find(parameters, parameter->name, &FunctionParameter::name) !=
            parameters.end()) {
            stream.errors.push_back(
                base::error(parameter->span, fmt::format("'{}' has two parameters of the name '{}'",
                                                         function, parameter->name)));
            return std::nullopt;
        }
        parameters.push_back(*std::move(parameter));
    } while (stream.accept(","));
    if (stream.accept(")")) return parameters;
    if (!parameters.back().initial) {
        stream.fail(fmt::format(
            "expected ',', '=' or ')' after '{}'; a function is defined by the names of its "
            "parameters, as in 'f(a, b = 1) = a + b'",
            stream.last()));
    } else if (stream.at(Token::Kind::sign) && !stream.at("(")) {
        stream.fail(
            fmt::format("unexpected '{}'; put brackets around the initial value", stream.next()));
    } else {
        stream.fail_behind_expression();
    }
    return std::nullopt;
}

}  // namespace formula
