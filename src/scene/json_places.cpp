// SPDX-License-Identifier: MIT
// Which byte of a JSON text each byte of a decoded text comes from.
#include <cassert>

#include "scene/json.h"

namespace scene {
namespace {

unsigned hexadecimal(std::string_view digits) {
    unsigned value = 0;
    for (char c : digits) {
        value = value * 16 + static_cast<unsigned>(c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10);
    }
    return value;
}

/// How many bytes of source an escape takes, and how many bytes of UTF-8 it stands for.
std::pair<std::size_t, std::size_t> escape_lengths(std::string_view source, std::size_t at) {
    if (source[at + 1] != 'u') return {2, 1};
    const unsigned code = hexadecimal(source.substr(at + 2, 4));
    if (code >= 0xD800 && code < 0xDC00) return {12, 4};  // a pair of surrogates
    return {6, code < 0x80 ? 1 : code < 0x800 ? 2 : 3};
}

}  // namespace

std::vector<std::uint32_t> text_places(std::string_view source, base::SourceSpan span) {
    assert(span.end >= span.begin + 2 && source[span.begin] == '"');
    std::vector<std::uint32_t> places;
    std::size_t at = span.begin + 1;
    while (at + 1 < span.end) {
        const auto [taken, made] = source[at] == '\\' ? escape_lengths(source, at)
                                                      : std::pair<std::size_t, std::size_t>{1, 1};
        places.insert(places.end(), made, static_cast<std::uint32_t>(at));
        at += taken;
    }
    places.push_back(static_cast<std::uint32_t>(at));
    return places;
}

}  // namespace scene
