// SPDX-License-Identifier: MIT
// Where a map takes a region.
#pragma once

#include <array>
#include <span>

#include "analysis/region.h"
#include "analysis/supremum.h"
#include "eval/tape.h"

namespace analysis {

/// A box that holds the image of the region wherever the map is defined; nothing if no bounded one
/// was found. `map` has one component a tape. Larger than it need be by about a twentieth.
std::optional<Region> image_region(const std::array<eval::Tape, 3>& map, const Region& region,
                                   std::span<const double> parameters, const Effort& effort = {});

}  // namespace analysis
