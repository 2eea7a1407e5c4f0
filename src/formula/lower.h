// SPDX-License-Identifier: MIT
// From the syntax tree to the field: looks names up, checks what may stand where, builds the graph.
#pragma once

#include <map>
#include <string_view>

#include "base/result.h"
#include "field/field.h"
#include "formula/ast.h"

namespace formula {

struct Lowered {
    field::Field field;
    base::Diagnostics warnings;  ///< in the order of the text
    base::SourceSpan result;     ///< of the last expression
    /// Leaves that are comparisons as they stand in the text, and where; without those in the
    /// bodies of functions and those that a map or a blend has made something else of.
    std::map<field::FieldId, base::SourceSpan> comparisons;
};

/// The field of a program that was parsed from this text. All errors are found, in the order of the
/// text: what comes of an expression with an error causes no further ones, and a Broken expression
/// causes none. Nothing is simplified.
base::Result<Lowered> lower(const Program& program, std::string_view text);

/// Parses and lowers; if only some statements fit the grammar, the others are checked all the same,
/// so that the errors of both steps are reported together. What all users of the library call.
base::Result<Lowered> understand(std::string_view text);

}  // namespace formula
