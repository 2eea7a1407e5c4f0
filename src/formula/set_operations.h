// SPDX-License-Identifier: MIT
// Unions, intersections and complements of fields, with the rules for sheets. Internal to the
// library.
#pragma once

#include <vector>

#include "formula/lowering.h"

namespace formula {

/// A field together with the expression that it came from, for errors.
struct FieldOperand {
    FieldValue field;
    ExpressionId expression{};
};

/// The union as a balanced tree, so that long chains stay flat; leaves keep their order.
FieldValue unite(Lowering& lowering, const std::vector<FieldOperand>& operands);

/// The intersection, likewise; an error if two of them are sheets.
Value intersect(Lowering& lowering, const std::vector<FieldOperand>& operands);

/// The complement; an error for a sheet.
std::optional<FieldValue> complement(Lowering& lowering, const FieldOperand& operand);

/// Reports an operand that is a sheet where only a solid can stand; `problem` is the sentence
/// before the hint. True if it is a solid.
bool require_solid(Lowering& lowering, const FieldOperand& operand, std::string_view problem);

}  // namespace formula
