// SPDX-License-Identifier: MIT
// The limits of the language. They are checked before or while the text is taken apart, so that no
// formula can exhaust the stack or the memory.
#pragma once

#include <cstddef>

namespace formula {

inline constexpr std::size_t max_text_bytes = 65536;   ///< of the whole formula
inline constexpr std::size_t max_brackets = 200;       ///< brackets that are open at one place
inline constexpr std::size_t max_height = 1000;        ///< levels of the syntax tree
inline constexpr std::size_t max_nodes = 100000;       ///< of the graph
inline constexpr std::size_t max_objects = 10000;      ///< leaves of the field, repeated ones too
inline constexpr std::size_t max_turns = 10000;        ///< of an iteration
inline constexpr std::size_t max_errors = 20;          ///< reported for one text
inline constexpr std::size_t max_expansions = 200000;  ///< expressions, at each call the body's
inline constexpr std::size_t max_depth = 1500;         ///< levels of expressions, through calls
inline constexpr std::size_t max_calls = 100;          ///< of functions, one inside of the other
inline constexpr int max_squared_power = 32;           ///< whole powers of vectors without angles

}  // namespace formula
