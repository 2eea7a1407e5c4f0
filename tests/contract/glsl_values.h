// SPDX-License-Identifier: MIT
// Expressions as users get them on the GPU: written by shader::ExpressionWriter, drawn by OSMesa.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "contract/operator_table.h"
#include "graph/graph.h"
#include "render/context.h"
#include "shader/precision.h"

namespace contract {

/// A fragment shader that evaluates up to four expressions at the numbers that its pixel has in the
/// uniform block of the field's values: variable 0 of the graph is the first of them, and so on.
/// Nothing if an expression has a part that depends on no variable, which GLSL never computes.
std::optional<std::string> expression_program(
    const graph::Graph& graph, std::span<const graph::NodeId> roots,
    shader::Precision precision = shader::Precision::single);

/// The same for one operator on the numbers. In double precision the value comes in three parts,
/// the largest first, whose sum it is.
std::string operator_program(graph::Op op, shader::Precision precision = shader::Precision::single);

/// The values of a program's expressions, one list for each place. The context must be current. An
/// empty list means that something failed, which has been reported to GoogleTest.
std::vector<std::array<float, 4>> glsl_values(const render::Context& context,
                                              const std::string& program,
                                              std::span<const Arguments> places);

}  // namespace contract
