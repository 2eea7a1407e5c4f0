// SPDX-License-Identifier: MIT
#include "base/diagnostic.h"

#include <algorithm>
#include <utility>

namespace base {
namespace {

constexpr std::size_t widest_line = 160;

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

std::size_t count_characters(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return !continues_character(c); }));
}

/// The line around an offset, without its end.
std::string_view line_around(std::string_view text, std::size_t offset) {
    const std::size_t before = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    const std::size_t end = std::min(text.find('\n', offset), text.size());
    return text.substr(begin, end - begin);
}

/// The source line and the caret below it. Tabs stay tabs in both, so that they line up.
std::string excerpt(std::string_view text, SourceSpan span) {
    std::string_view line = line_around(text, span.begin);
    std::size_t at = span.begin - static_cast<std::size_t>(line.data() - text.data());
    if (line.size() > widest_line) {
        std::size_t begin =
            std::min(at > widest_line / 2 ? at - widest_line / 2 : 0, line.size() - widest_line);
        while (begin < at && continues_character(line[begin])) ++begin;
        std::size_t end = std::min(begin + widest_line, line.size());
        while (end < line.size() && continues_character(line[end])) ++end;
        line = line.substr(begin, end - begin);
        at -= begin;
    }
    at = std::min(at, line.size());
    std::string marks;
    for (char c : line.substr(0, at)) {
        if (!continues_character(c)) marks += c == '\t' ? '\t' : ' ';
    }
    marks += '^';
    const std::size_t length = span.end > span.begin ? span.end - span.begin : 0;
    const std::size_t marked = count_characters(line.substr(at, length));
    if (marked > 1) marks.append(marked - 1, '~');
    std::string shown(line);
    std::replace(shown.begin(), shown.end(), '\r', ' ');
    return shown + '\n' + marks + '\n';
}

}  // namespace

Diagnostic error(std::string message) {
    return {Severity::error, std::move(message), std::nullopt};
}

Diagnostic error(SourceSpan span, std::string message) {
    return {Severity::error, std::move(message), span};
}

Diagnostic warning(SourceSpan span, std::string message) {
    return {Severity::warning, std::move(message), span};
}

bool has_errors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::error; });
}

LineColumn line_column(std::string_view text, std::size_t offset) {
    offset = std::min(offset, text.size());
    const std::string_view before = text.substr(0, offset);
    const std::size_t newline = before.rfind('\n');
    const std::size_t begin = newline == std::string_view::npos ? 0 : newline + 1;
    return {1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')),
            1 + count_characters(before.substr(begin))};
}

std::string format(const Diagnostic& diagnostic, std::string_view name, std::string_view text) {
    std::string out(name);
    if (diagnostic.span) {
        const LineColumn place = line_column(text, diagnostic.span->begin);
        out += ':' + std::to_string(place.line) + ':' + std::to_string(place.column);
    }
    out += diagnostic.severity == Severity::error ? ": error: " : ": warning: ";
    out += diagnostic.message;
    out += '\n';
    if (diagnostic.span) {
        const SourceSpan span{std::min<std::uint32_t>(diagnostic.span->begin, text.size()),
                              std::min<std::uint32_t>(diagnostic.span->end, text.size())};
        out += excerpt(text, span);
    }
    return out;
}

}  // namespace base
