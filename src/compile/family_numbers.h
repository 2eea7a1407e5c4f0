// SPDX-License-Identifier: MIT
// What the program of a field with families is fed with.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "analysis/active_cells.h"
#include "analysis/region.h"
#include "shader/family_table.h"

namespace compile {

/// The members of a family as operands, with the numbers that they have for these values of the
/// parameters (by ParameterId); the operands refer to the table and the parameters.
analysis::Operands operands(const shader::FamilyTable& table, std::span<const double> parameters);

/// FamilyHead by number.
using FamilyHeads = std::array<float, shader::family_head_size>;

/// Adds the texels of a tree to those of others, for members that are looked at in this region (in
/// the coordinates of its cells), and returns what else the program is told of its families, in the
/// order of `tables`. Takes milliseconds.
std::vector<FamilyHeads> add_tree(std::vector<float>& texels, const shader::FamilyTree& tree,
                                  std::span<const shader::FamilyTable> tables,
                                  const analysis::Region& region,
                                  std::span<const double> parameters,
                                  const analysis::Budget* budget = nullptr);

}  // namespace compile
