// SPDX-License-Identifier: MIT
// Which characters may stand in a formula, and what to type instead of the others.
#pragma once

#include <string_view>

#include "base/diagnostic.h"

namespace formula {

/// One error for each character that cannot be used at its place: bytes that are not UTF-8, control
/// characters, and outside comments and labels all that the language has no use for. At most
/// max_errors of them.
base::Diagnostics check_characters(std::string_view text);

}  // namespace formula
