// SPDX-License-Identifier: MIT
// What the program of a field with families is fed with.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "analysis/active_lists.h"
#include "analysis/region.h"
#include "shader/family_table.h"

namespace compile {

/// The members of a family as operands, with the numbers that they have for these values of the
/// parameters (by ParameterId); the operands refer to the table.
analysis::Operands operands(const shader::FamilyTable& table, std::span<const double> parameters);

/// Adds the texels of a family to those of others, for members that are looked at in this region
/// (in the coordinates of its cells), and returns what else the program is told: FamilyHead by
/// number. Takes milliseconds.
std::array<float, shader::family_head_size> add_family(std::vector<float>& texels,
                                                       const shader::FamilyTable& table,
                                                       const analysis::Region& region,
                                                       std::span<const double> parameters);

}  // namespace compile
