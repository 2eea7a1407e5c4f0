// SPDX-License-Identifier: MIT
// Finding out what somebody meant where JSON ends: by the place, the token there, and what came
// before.
#include "scene/json_syntax.h"

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "scene/utf8.h"

namespace scene {
namespace {

using After = JsonStop::After;

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_number_part(char c) {
    return is_digit(c) || is_letter(c) || c == '.' || c == '+' || c == '-';
}

base::SourceSpan span_of(std::size_t begin, std::size_t end) {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

base::Diagnostic cut_off(std::string_view text) {
    std::size_t end = text.size();
    while (end > 0 && is_space(text[end - 1])) --end;
    if (end == 0) return base::error(span_of(0, 0), "the file is empty");
    return base::error(span_of(end, end),
                       "the file ends in the middle of the preset; it may have been cut off");
}

/// The word or number that begins at a place, or the one character there.
std::string_view token_at(std::string_view text, std::size_t begin) {
    std::size_t end = begin;
    while (end < text.size() && is_number_part(text[end])) ++end;
    if (end == begin) end += std::max<std::size_t>(1, utf8_length(text, begin));
    return text.substr(begin, end - begin);
}

/// What is wrong inside of a text in quotes, if anything is.
std::optional<base::Diagnostic> text_problem(std::string_view text, std::size_t begin) {
    constexpr std::string_view escapes = "\"\\/bfnrtu";
    for (std::size_t at = begin + 1; at < text.size() && text[at] != '"'; ++at) {
        if (static_cast<unsigned char>(text[at]) < 0x20) {
            return base::error(
                span_of(begin, at),
                text[at] == '\n' || text[at] == '\r'
                    ? "a text must be closed with '\"' on its own line; write \\n for "
                      "a line break in it"
                    : "a text cannot hold a control character such as a tab; write "
                      "\\t for a tab");
        }
        if (text[at] != '\\') continue;
        ++at;
        if (at >= text.size()) break;
        if (escapes.find(text[at]) == std::string_view::npos) {
            return base::error(
                span_of(at - 1, at + std::max<std::size_t>(1, utf8_length(text, at))),
                "this backslash has no meaning in a text; write \\\\ for a backslash");
        }
        if (text[at] != 'u') continue;
        const std::string_view digits = text.substr(at + 1, 4);
        const bool hexadecimal =
            digits.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
        const bool surrogate = !digits.empty() && (digits[0] == 'd' || digits[0] == 'D');
        if (digits.size() < 4 || !hexadecimal) {
            return base::error(span_of(at - 1, at + 1), "\\u needs four hexadecimal digits");
        }
        if (!surrogate || digits[1] < '8') continue;
        const bool low_first = digits[1] != '8' && digits[1] != '9' && digits[1] != 'a' &&
                               digits[1] != 'A' && digits[1] != 'b' && digits[1] != 'B';
        const std::string_view next = text.substr(std::min(at + 5, text.size()), 2);
        if (low_first || next != "\\u") {
            return base::error(span_of(at - 1, at + 5),
                               "this \\u is half of a character; write the character itself");
        }
        at += 6;
    }
    return std::nullopt;
}

bool is_json_number(std::string_view token) {
    std::size_t at = token.starts_with('-') ? 1 : 0;
    const auto digits = [&] {
        const std::size_t begin = at;
        while (at < token.size() && is_digit(token[at])) ++at;
        return at - begin;
    };
    const bool zero = at < token.size() && token[at] == '0';
    const std::size_t whole = digits();
    if (whole == 0 || (zero && whole > 1)) return false;
    if (at < token.size() && token[at] == '.') {
        ++at;
        if (digits() == 0) return false;
    }
    if (at < token.size() && (token[at] == 'e' || token[at] == 'E')) {
        ++at;
        if (at < token.size() && (token[at] == '+' || token[at] == '-')) ++at;
        if (digits() == 0) return false;
    }
    return at == token.size();
}

/// A token that is no JSON in any place.
std::optional<std::string> token_problem(std::string_view token) {
    const std::string_view bare =
        token.substr(token.starts_with('-') || token.starts_with('+') ? 1 : 0);
    for (std::string_view name : {"NaN", "nan", "NAN", "Infinity", "infinity", "inf", "Inf"}) {
        if (bare == name) return fmt::format("{} is not a number; write a finite one", token);
    }
    for (std::string_view name : {"true", "false", "null"}) {
        const bool same = token.size() == name.size() && token != name &&
                          std::equal(name.begin(), name.end(), token.begin(),
                                     [](char a, char b) { return a == (b | 0x20); });
        if (same) return fmt::format("unknown word {}; did you mean {}?", token, name);
    }
    if (token == "true" || token == "false" || token == "null") return std::nullopt;
    if (token[0] == '\'') return "texts stand between double quotes, not single ones";
    if (token[0] == '/' || token[0] == '#') {
        return "a preset cannot hold comments; use the field 'description'";
    }
    if (is_letter(token[0])) {
        return fmt::format("unknown word {}; texts stand between double quotes", token);
    }
    if (is_digit(token[0]) || token[0] == '-' || token[0] == '+' || token[0] == '.') {
        if (!is_json_number(token)) {
            return fmt::format("{} is not a number as JSON writes it, such as -0.5 or 1e-3", token);
        }
    }
    return std::nullopt;
}

/// What should stand at a place where something else is.
std::string expectation(std::string_view text, const JsonStop& stop, std::size_t begin) {
    const std::string_view between = text.substr(stop.last_end, begin - stop.last_end);
    const bool comma = between.find(',') != std::string_view::npos;
    const bool closing = text[begin] == '}' || text[begin] == ']';
    const std::string_view container = stop.in_object ? "'}'" : "']'";
    switch (stop.after) {
        case After::nothing:
            return "a preset begins with '{'";
        case After::key:
            return between.find(':') == std::string_view::npos
                       ? "a ':' is missing after the name of a field"
                       : "the value of the field is missing";
        case After::opening:
            return stop.in_object ? "the name of a field in double quotes, or '}', is missing"
                                  : "a value, or ']', is missing";
        case After::value:
            if (comma && closing) return "the ',' before this bracket must go";
            if (!comma) return fmt::format("a ',' or {} is missing", container);
            return stop.in_object ? "the name of a field in double quotes is missing"
                                  : "a value is missing";
        case After::everything:
            return "there is more text after the end of the preset";
    }
    return {};
}

/// The parser takes the beginning of "01" or "1.2.3" for a number and stops at the rest.
std::optional<base::Diagnostic> last_number_problem(std::string_view text, const JsonStop& stop) {
    std::size_t begin = stop.last_end;
    while (begin > 0 && is_number_part(text[begin - 1])) --begin;
    if (begin == stop.last_end) return std::nullopt;
    const std::string_view token = token_at(text, begin);
    if (!is_digit(token[0]) && token[0] != '-') return std::nullopt;
    if (const auto problem = token_problem(token)) {
        return base::error(span_of(begin, begin + token.size()), *problem);
    }
    return std::nullopt;
}

}  // namespace

base::Diagnostic explain_json_stop(std::string_view text, const JsonStop& stop) {
    if (stop.after == After::value) {
        if (const auto problem = last_number_problem(text, stop)) return *problem;
    }
    std::size_t begin = stop.last_end;
    const auto between = [&](char c) { return is_space(c) || c == ',' || c == ':'; };
    while (begin + 1 < stop.consumed && between(text[begin])) ++begin;
    while (begin < text.size() && is_space(text[begin])) ++begin;
    if (begin >= text.size()) return cut_off(text);
    const std::string_view token = token_at(text, begin);
    const base::SourceSpan span = span_of(begin, begin + token.size());
    if (stop.after == After::everything) return base::error(span, expectation(text, stop, begin));
    if (token[0] == '"') {
        if (const auto problem = text_problem(text, begin)) return *problem;
    }
    if (stop.ran_out) return cut_off(text);
    if (const auto problem = token_problem(token)) return base::error(span, *problem);
    if (is_json_number(token) && stop.after != After::nothing) {
        const std::string_view gap = text.substr(stop.last_end, begin - stop.last_end);
        const bool value_is_due = !stop.in_object
                                      ? stop.after == After::opening || gap.find(',') != gap.npos
                                      : stop.after == After::key && gap.find(':') != gap.npos;
        if (value_is_due)
            return base::error(span, fmt::format("the number {} is too large", token));
    }
    return base::error(span, expectation(text, stop, begin));
}

}  // namespace scene
