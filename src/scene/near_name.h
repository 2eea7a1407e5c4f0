// SPDX-License-Identifier: MIT
// The name that somebody probably meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scene {

/// The candidate with the fewest mistyped letters (inserted, left out, replaced, or two neighbours
/// swapped), the first of equals; empty if none is close. Upper and lower case count as equal.
std::string near_name(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace scene
