// SPDX-License-Identifier: MIT
// The words that mean something only where they stand. Everywhere else they are names.
#pragma once

#include <span>
#include <string_view>

namespace formula {

/// What an expression is a part of.
enum class Within { statement, parameter, iteration };

/// False for the keywords that end an expression there: `in` and `step` in a parameter (with
/// brackets behind it, `called`, step is the function), `for` and `until` in the head of an
/// iteration. Also false for no word at all.
bool is_name(Within within, std::string_view word, bool called);

/// What may follow the value of a parameter.
std::span<const std::string_view> modifiers();

/// True if a word behind a number is rather a modifier of a parameter than a factor: it is one, or
/// nearly spelled like one.
bool resembles_modifier(Within within, std::string_view word);

}  // namespace formula
