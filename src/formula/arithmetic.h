// SPDX-License-Identifier: MIT
// The arithmetic of numbers and vectors: which types go together, and what comes out. Internal to
// the library.
#pragma once

#include "formula/lowering.h"

namespace formula {

/// The value of an expression if it is a number or a vector; an error otherwise, `where` as in
/// as_number.
std::optional<Value> as_operand(Lowering& lowering, ExpressionId id, std::string_view where);

// Each takes operands, and answers Nothing after an error at the span, which is the operation's.
// Orbits are carried along.

Value negative(Lowering& lowering, const Value& a);
/// a + b, a - b, a * b or a / b.
Value combine(Lowering& lowering, Joint joint, base::SourceSpan span, const Value& a,
              const Value& b);
/// a^b. Whole powers that are known are computed by squaring, up to max_squared_power.
Value raise(Lowering& lowering, base::SourceSpan span, const Value& a, const Value& b);

/// The algebra of what is made of both componentwise: plain vectors take the other's. Nothing if
/// sizes or algebras differ.
std::optional<Algebra> common_algebra(const VectorValue& a, const VectorValue& b);

/// The name of the function that makes such a value: `quaternion`.
std::string_view constructor(Algebra algebra);

}  // namespace formula
