// SPDX-License-Identifier: MIT
// Which formulas of a field are known brick by brick, and what a program reads of them.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "analysis/region.h"
#include "compile/field_bounds.h"
#include "field/field.h"
#include "shader/field_numbers.h"

namespace compile {

/// The formulas, in no cells and no blends, whose derivatives may be much smaller near their
/// surface than somewhere else, or unbounded somewhere. By structure: for others one bound of the
/// region does as well, or one that follows from how they are made of distances. At most a few.
std::vector<field::FieldId> brick_leaves(const field::Field& field);

/// Whether it pays to look for bricks that hold nothing of the scene. By structure: rays through
/// cells end a step at each wall; iterations take too long to follow in intervals.
bool has_scene_bricks(const field::Field& field);

/// What programs that list these leaves read, and where the scene is if `scene`; over the region.
/// The same for any number of cores, without a budget. Milliseconds.
std::shared_ptr<const shader::BrickTexels> brick_texels(const field::Field& field,
                                                        const BoundTapes& tapes,
                                                        std::span<const field::FieldId> leaves,
                                                        bool scene, const analysis::Region& region,
                                                        std::span<const double> parameters,
                                                        const analysis::Budget* budget = nullptr);

}  // namespace compile
