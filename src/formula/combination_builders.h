// SPDX-License-Identifier: MIT
// The functions behind the table of combinations. Internal to the library.
#pragma once

#include "formula/lowering.h"

namespace formula {

// Set operations.
Value build_union(Lowering&, const Call&);
Value build_intersection(Lowering&, const Call&);
Value build_difference(Lowering&, const Call&);
Value build_complement(Lowering&, const Call&);

// Blends of values.
Value build_smooth_union(Lowering&, const Call&);
Value build_smooth_union_exp(Lowering&, const Call&);
Value build_smooth_union_power(Lowering&, const Call&);
Value build_smooth_intersection(Lowering&, const Call&);
Value build_smooth_difference(Lowering&, const Call&);
Value build_offset(Lowering&, const Call&);
Value build_shell(Lowering&, const Call&);
Value build_displace(Lowering&, const Call&);
Value build_morph(Lowering&, const Call&);

Value build_colour(Lowering&, const Call&);

// Maps of space.
Value build_translate(Lowering&, const Call&);
Value build_rotate(Lowering&, const Call&);
Value build_scale(Lowering&, const Call&);
Value build_mirror(Lowering&, const Call&);
Value build_twist(Lowering&, const Call&);
Value build_bend(Lowering&, const Call&);
Value build_map(Lowering&, const Call&);
Value build_repeat(Lowering&, const Call&);
Value build_repeat_polar(Lowering&, const Call&);

}  // namespace formula
