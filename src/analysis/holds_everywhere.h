// SPDX-License-Identifier: MIT
// Proofs by exhaustion: a statement about cells that is shown for cells that cover a region.
#pragma once

#include <functional>

#include "analysis/region.h"
#include "analysis/supremum.h"

namespace analysis {

/// True if `holds` is true of cells that together cover the region: a proof, if `holds` is one for
/// a cell. False where none was found with this effort. A statement that fails at a single point is
/// given up after twice `effort.depth` cells.
bool holds_everywhere(const Region& region, const Effort& effort,
                      const std::function<bool(const Cell&)>& holds);

}  // namespace analysis
