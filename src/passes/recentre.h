// SPDX-License-Identifier: MIT
// A field in coordinates about another origin.
#pragma once

#include <array>

#include "field/field.h"

namespace passes {

/// Rewrites a field that has passed through the passes, and has no cells, from world coordinates to
/// those relative to an origin, which are three new parameters (their ids are returned): x becomes
/// a + x. Every value is written as that at the origin, which is the same for all points and so is
/// computed in double once a frame, and the way from there, which near the origin is found without
/// a difference of large numbers: sums, products, square roots and lengths, sines and cosines,
/// absolute values, minima and maxima by their addition theorems. All other operators, and
/// iterations after their start, get the sum of the two, rounded as it is. Equal over the real
/// numbers; up to rounding in between.
std::array<graph::ParameterId, 3> recentre(field::Field& field);

}  // namespace passes
