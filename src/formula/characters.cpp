// SPDX-License-Identifier: MIT
#include "formula/characters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "formula/limits.h"

namespace formula {
namespace {

struct LookAlike {
    char32_t character;
    std::string_view instead;
};

/// Signs that people paste or type, and their spelling in ASCII.
constexpr LookAlike look_alikes[] = {
    {U'\u00A0', "a space"},  {U'\u2009', "a space"},  {U'\u202F', "a space"}, {U'\u00D7', "'*'"},
    {U'\u00B7', "'*'"},      {U'\u22C5', "'*'"},      {U'\u2217', "'*'"},     {U'\u2219', "'*'"},
    {U'\u2022', "'*'"},      {U'\u2212', "'-'"},      {U'\u2010', "'-'"},     {U'\u2011', "'-'"},
    {U'\u2012', "'-'"},      {U'\u2013', "'-'"},      {U'\u2014', "'-'"},     {U'\u00F7', "'/'"},
    {U'\u2044', "'/'"},      {U'\u2215', "'/'"},      {U'\u2216', "'\\'"},    {U'\u00B0', "'^0'"},
    {U'\u2070', "'^0'"},     {U'\u00B9', "'^1'"},     {U'\u00B2', "'^2'"},    {U'\u00B3', "'^3'"},
    {U'\u2074', "'^4'"},     {U'\u2075', "'^5'"},     {U'\u2076', "'^6'"},    {U'\u2077', "'^7'"},
    {U'\u2078', "'^8'"},     {U'\u2079', "'^9'"},     {U'\u207B', "'^-'"},    {U'\u2264', "'<='"},
    {U'\u2265', "'>='"},     {U'\u2A7D', "'<='"},     {U'\u2A7E', "'>='"},    {U'\u222A', "'|'"},
    {U'\u2229', "'&'"},      {U'\u2228', "'|'"},      {U'\u2227', "'&'"},     {U'\u221A', "'sqrt'"},
    {U'\u221B', "'cbrt'"},   {U'\u03C0', "'pi'"},     {U'\u03C4', "'tau'"},   {U'\u201C', "'\"'"},
    {U'\u201D', "'\"'"},     {U'\uFF08', "'('"},      {U'\uFF09', "')'"},     {U'\uFF0C', "','"},
    {U'\uFF0B', "'+'"},      {U'\uFF0D', "'-'"},      {U'\uFF1D', "'='"},     {U'\uFF0A', "'*'"},
    {U'\u2018', "no quote"}, {U'\u2019', "no quote"},
};

/// ASCII characters that other languages use, and what to do here.
constexpr LookAlike foreign[] = {
    {U'%', "'mod(a, b)'"},
    {U'{', "'('"},
    {U'}', "')'"},
    {U'!', "a comparison with '=', '<=' or '>='"},
    {U'~', "'complement(F)'"},
    {U'\'', "no quote"},
    {U'`', "no quote"},
};

struct Character {
    char32_t code = 0;
    std::uint32_t length = 1;
};

/// The character at the front of a text that is not empty; nothing if it is no valid UTF-8.
std::optional<Character> decode(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return Character{lead, 1};
    const std::uint32_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return std::nullopt;
    char32_t code = lead & (0xFFu >> (length + 1));
    for (std::uint32_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return std::nullopt;
        code = code << 6 | (byte(i) & 0x3F);
    }
    constexpr std::array<char32_t, 5> smallest{0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < smallest[length] || code > 0x10FFFF || surrogate) return std::nullopt;
    return Character{code, length};
}

bool is_control(char32_t code) {
    return (code < 0x20 && code != U'\n' && code != U'\r' && code != U'\t') ||
           (code >= 0x7F && code <= 0x9F);
}

bool is_used(char32_t code) {
    constexpr std::string_view signs = " \t\r\n_.+-*/^()[],:;=<>&|\\#\"";
    const bool letter = (code >= U'a' && code <= U'z') || (code >= U'A' && code <= U'Z');
    const bool digit = code >= U'0' && code <= U'9';
    return letter || digit ||
           (code < 0x80 && signs.find(static_cast<char>(code)) != std::string_view::npos);
}

std::string complain(std::string_view character, char32_t code) {
    for (const LookAlike& it : look_alikes) {
        if (it.character == code) {
            return fmt::format("'{}' is not a sign of the language; write {}", character,
                               it.instead);
        }
    }
    for (const LookAlike& it : foreign) {
        if (it.character == code) {
            return fmt::format("'{}' is not a sign of the language; write {}", character,
                               it.instead);
        }
    }
    if (code < 0x80) return fmt::format("'{}' is not a sign of the language", character);
    return fmt::format("'{}' cannot be used; names are made of the letters a to z, digits and '_'",
                       character);
}

}  // namespace

base::Diagnostics check_characters(std::string_view text) {
    base::Diagnostics errors;
    bool comment = false;
    bool label = false;
    std::uint32_t at = 0;
    while (at < text.size() && errors.size() < max_errors) {
        const std::optional<Character> character = decode(text.substr(at));
        if (!character) {
            errors.push_back(base::error({at, at + 1}, "this byte is not valid UTF-8"));
            ++at;
            continue;
        }
        const auto [code, length] = *character;
        const base::SourceSpan span{at, at + length};
        at += length;
        if (code == U'\n') comment = label = false;
        if (!comment && code == U'"') label = !label;
        if (!label && code == U'#') comment = true;
        if (is_control(code)) {
            errors.push_back(base::error(
                span, fmt::format("the control character U+{:04X} cannot be used; delete it",
                                  static_cast<std::uint32_t>(code))));
        } else if (!comment && !label && !is_used(code)) {
            const bool unequal = code == U'!' && text.substr(at, 1) == "=";
            errors.push_back(
                base::error(unequal ? base::SourceSpan{span.begin, span.end + 1} : span,
                            unequal ? "there is no '!='; compare with '=', '<=' or '>='"
                                    : complain(text.substr(span.begin, length), code)));
        }
    }
    return errors;
}

}  // namespace formula
