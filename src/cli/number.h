// SPDX-License-Identifier: MIT
// Numbers as they are typed on a command line.
#pragma once

#include <optional>
#include <string_view>

namespace cli {

/// A finite number in the C locale, and nothing besides it.
std::optional<double> finite_number(std::string_view text);

}  // namespace cli
