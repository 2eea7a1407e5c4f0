// SPDX-License-Identifier: MIT
// The texts of tests/bench/plain/, compiled in.
#pragma once

#include <functional>
#include <map>
#include <string>

namespace bench {

/// Each text by its name, such as "mandelbulb.glsl".
const std::map<std::string, std::string, std::less<>>& plain_parts();

}  // namespace bench
