// SPDX-License-Identifier: MIT
// What is called with fields and gives a field: set operations, blends, and maps of space.
#pragma once

#include <span>
#include <string_view>

#include "formula/lowering.h"

namespace formula {

struct Combination {
    std::string_view name;
    std::string_view signature;  ///< how a call is written
    Value (*build)(Lowering&, const Call&);
};

/// All of them, sorted by name.
std::span<const Combination> combinations();
const Combination* find_combination(std::string_view name);

}  // namespace formula
