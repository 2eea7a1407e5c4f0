// SPDX-License-Identifier: MIT
// How far two spellings are apart.
#pragma once

#include <cstddef>
#include <string_view>

namespace base {

/// How many letters must be inserted, left out, replaced, or swapped with their neighbour to get
/// from one name to the other (the optimal string alignment distance). Upper and lower case of
/// ASCII letters count as equal.
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace base
