// SPDX-License-Identifier: MIT
// A piece of a source text, by byte offsets.
#pragma once

#include <cstdint>

namespace base {

/// The bytes [begin, end) of a text. An empty span marks a place between two bytes.
struct SourceSpan {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    friend bool operator==(const SourceSpan&, const SourceSpan&) = default;
};

/// The smallest span that covers both.
constexpr SourceSpan cover(SourceSpan a, SourceSpan b) {
    return {a.begin < b.begin ? a.begin : b.begin, a.end > b.end ? a.end : b.end};
}

}  // namespace base
