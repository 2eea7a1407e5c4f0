// SPDX-License-Identifier: MIT
// The names that stand in an expression, without looking at what they mean. Internal to the
// library.
#pragma once

#include <set>
#include <string_view>
#include <vector>

#include "base/source_span.h"
#include "formula/ast.h"

namespace formula {

/// Views into the program. The name of an argument, as in `f(a = 1)`, is not among them.
using Mentions = std::set<std::string_view>;
Mentions mentions(const Program& program, ExpressionId id);

/// The definitions through which one statement of the program needs itself, from its own name to
/// its own name again; `from` is the number of that statement, `next` a name that it uses. Empty if
/// it does not.
std::vector<std::string_view> cycle(const Program& program, std::size_t from,
                                    std::string_view next);

}  // namespace formula
