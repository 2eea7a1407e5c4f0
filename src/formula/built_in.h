// SPDX-License-Identifier: MIT
// The names that every formula knows, over all tables.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "field/primitives.h"

namespace formula {

/// True for x, y and z, the only names that cannot be defined anew.
bool is_coordinate(std::string_view name);

/// True for what is called with arguments in brackets: functions of numbers and vectors, `if`,
/// combinations of fields, primitives, and what the prelude defines.
bool is_callable(std::string_view name);

/// How a callable is called: `atan2(y, x)`, `sphere(r = 1)`.
std::string signature(std::string_view callable);
std::string signature(const field::Primitive& primitive);

/// Coordinates, constants and callables, sorted.
std::vector<std::string_view> built_in_names();

}  // namespace formula
