// SPDX-License-Identifier: MIT
// How a number is spelled.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace formula {

/// How many bytes at the front of the text are a number: digits with or without a point (`2`, `2.`,
/// `.5`), and an exponent only if digits follow it (`2e+1`; but `2e` is a 2). 0 if there is none.
std::size_t number_length(std::string_view text);

/// The nearest double of a spelled number, 0 if it is too small for one; nothing if it is too
/// large.
std::optional<double> number_value(std::string_view spelling);

}  // namespace formula
