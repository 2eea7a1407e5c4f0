// SPDX-License-Identifier: MIT
// Guesses which name was meant.
#pragma once

#include <span>
#include <string_view>

namespace formula {

/// The candidate that was probably meant: another spelling of capitals, a common name of the same
/// thing elsewhere (`ln`, `arcsin`), or one that is one letter away, two letters for names of six
/// or more; empty if there is none. Of several at the same distance the first in the alphabet.
std::string_view nearest(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace formula
