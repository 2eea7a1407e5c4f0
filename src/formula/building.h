// SPDX-License-Identifier: MIT
// What the grammar's actions build, and where words end and products are implied. Internal to the
// library.
#pragma once

#include <string_view>

#include "base/diagnostic.h"
#include "formula/ast.h"
#include "formula/words.h"

namespace formula {

using Place = const char*;

/// The state of parsing one expression.
struct Building {
    Place text;
    Program& program;
    base::Diagnostics& errors;
    Within within = Within::statement;
    Place number_end = nullptr;  ///< where the last number ended
    bool too_high = false;       ///< a tree is higher than max_height, and that is reported

    base::SourceSpan span(Place begin, Place end) const {
        return {static_cast<std::uint32_t>(begin - text), static_cast<std::uint32_t>(end - text)};
    }
    /// Adds a node to the program; reports the first that is too high.
    ExpressionId add(ExpressionNode node, base::SourceSpan span);
};

/// The text between two places.
std::string_view between(Place first, Place last);

// Each of these says where something ends that begins at `first`: there, if it is not there.
Place number_end(Place first, Place last);
Place word_end(Place first, Place last);
/// A word that is a name where the expression stands.
Place name_end(const Building& building, Place first, Place last);

/// Reports letters that are no components, and too many of them.
void check_components(std::string_view letters, base::SourceSpan span, base::Diagnostics& errors);

/// True if a bracket is opened next, on the same line, as a call needs it.
bool opens_bracket(Place first, Place last);

/// True where components are taken from what stands before: at a point that touches it and does not
/// begin a number.
bool selects_components(const Building& building, Place first, Place last);

/// True where `*` may be left out: between a number and a name or a bracket, and between a closing
/// bracket and a name, a number or a bracket; on one line. A word that goes on with a declaration
/// is no factor.
bool implies_product(const Building& building, Place first, Place last);

}  // namespace formula
