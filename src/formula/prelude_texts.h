// SPDX-License-Identifier: MIT
// The texts of prelude/, compiled in. Internal to the library.
#pragma once

#include <map>
#include <string>

namespace formula {

/// Each definition's text by the name of its file, such as `julia.zeroset`.
const std::map<std::string, std::string, std::less<>>& prelude_texts();

}  // namespace formula
