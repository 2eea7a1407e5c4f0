// SPDX-License-Identifier: MIT
// Says in words why a statement does not fit the grammar.
#pragma once

#include <string_view>

#include "base/diagnostic.h"
#include "formula/grammar.h"
#include "formula/statements.h"

namespace formula {

/// The error for a statement that left the grammar at a place: looks at the tokens around it and
/// says what is missing or what to write instead.
base::Diagnostic explain(std::string_view text, const StatementText& statement,
                         const SyntaxError& error);

}  // namespace formula
