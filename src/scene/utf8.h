// SPDX-License-Identifier: MIT
// Which bytes are UTF-8.
#pragma once

#include <cstddef>
#include <string_view>

namespace scene {

/// The number of bytes of the character at a place, 0 if there is no well-formed one (overlong
/// forms, surrogates and numbers above 10FFFF are not).
std::size_t utf8_length(std::string_view text, std::size_t at);

/// The first byte that belongs to no well-formed character, or the size of the text.
std::size_t first_broken_utf8(std::string_view text);

}  // namespace scene
