// SPDX-License-Identifier: MIT
// The GLSL of an escape-time leaf: a loop around its expressions.
#pragma once

#include <span>
#include <string>

#include "field/field.h"
#include "shader/expression_glsl.h"

namespace shader {

/// The body of `real value(real3 p, out bool inside)`: the distance expression at the final state,
/// and whether the iteration never escaped. What does not depend on the state is computed before
/// the loop; what both the escape and the next turn need is computed once and carried. The loop's
/// bound is a field value even if it is constant: drivers would unroll the loop and lose the early
/// exit.
std::string iteration_body(const graph::Graph& graph, const field::Iteration& iteration,
                           ExpressionWriter& writer, FieldValues& values);

/// The body of `real3 gradient(real3 p)`: that of the distance, of state and point, at the final
/// state.
std::string iteration_gradient(const graph::Graph& graph, const field::Iteration& iteration,
                               std::span<const graph::NodeId> gradient, ExpressionWriter& writer,
                               FieldValues& values);

/// The statements that compute the colour of an iteration that has one at a point `p`; carries only
/// the state that the colour needs.
std::string iteration_colour(const graph::Graph& graph, const field::Iteration& iteration,
                             ExpressionWriter& writer, FieldValues& values);

}  // namespace shader
