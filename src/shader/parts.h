// SPDX-License-Identifier: MIT
// The texts of shaders/, compiled in.
#pragma once

#include <functional>
#include <map>
#include <string>

namespace shader {

/// Each part's text by its path below shaders/, such as "light/blinn_phong.glsl".
const std::map<std::string, std::string, std::less<>>& parts();

}  // namespace shader
