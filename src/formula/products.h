// SPDX-License-Identifier: MIT
// Products, quotients and powers of vectors, which each algebra has its own of. Internal to the
// library.
#pragma once

#include "formula/lowering.h"

namespace formula {

// As in arithmetic.h: Nothing after an error at the span.

Value product(Lowering& lowering, base::SourceSpan span, const VectorValue& a,
              const VectorValue& b);
/// a / b, where a is a number or a vector.
Value quotient(Lowering& lowering, base::SourceSpan span, const Value& a, const VectorValue& b);
Value power(Lowering& lowering, base::SourceSpan span, const VectorValue& a,
            graph::NodeId exponent);

/// Of complex numbers and quaternions; nothing for other vectors, without an error.
std::optional<VectorValue> conjugate(Lowering& lowering, const VectorValue& a);
std::optional<VectorValue> inverse(Lowering& lowering, const VectorValue& a);

}  // namespace formula
