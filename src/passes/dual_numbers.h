// SPDX-License-Identifier: MIT
// Derivatives of an iteration's answers by the point, carried along with its state.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "field/field.h"

namespace passes {

/// Makes dual numbers of the state: beside what changes with x, y or z, as far as the roots (of
/// state and point) need it, the state carries the partial derivatives. Given are those of the
/// roots by x, y and z, of state and point, with the kinks of passes/differentiate.h. Nothing is
/// simplified; what the state held before stays where it is.
std::vector<std::array<graph::NodeId, 3>> add_derivatives(graph::Graph& graph,
                                                          field::Iteration& iteration,
                                                          std::span<const graph::NodeId> roots);

}  // namespace passes
