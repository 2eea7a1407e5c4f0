// SPDX-License-Identifier: MIT
// The operators as users get them on the GPU: written by shader::ExpressionWriter, drawn by OSMesa.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "contract/operator_table.h"
#include "graph/operator.h"
#include "render/context.h"

namespace contract {

/// A fragment shader that applies the operator to the arguments that its pixel has in the uniform
/// block of the field's values.
std::string operator_program(graph::Op op);

/// The operator's values, one for each place. The context must be current. An empty list means that
/// something failed, which has been reported to GoogleTest.
std::vector<float> glsl_values(const render::Context& context, graph::Op op,
                               std::span<const Arguments> places);

}  // namespace contract
