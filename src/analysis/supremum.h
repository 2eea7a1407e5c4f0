// SPDX-License-Identifier: MIT
// The supremum of something over a region, bounded from above by best-first bisection.
#pragma once

#include <functional>

#include "analysis/budget.h"
#include "analysis/region.h"

namespace analysis {

/// When to stop: bounds are rigorous wherever that happens.
struct Effort {
    int cells = 1500;  ///< at most so many cells are looked at
    double tolerance =
        0.05;        ///< stop when the bound is proven to be too large by this part at most
    int depth = 30;  ///< a cell halved so often that is still unbounded counts as unbounded
    const Budget* budget = nullptr;  ///< when it is over, cells are halved no more
};

/// What is known about the quantity on one cell.
struct CellBounds {
    double upper = 0;  ///< rigorous; +infinity if unknown
    double lower = 0;  ///< of the supremum: a value at some point, 0 if unknown
};

/// An upper bound of the supremum over the region, +infinity if none was found. `bounds` is called
/// for cells that together cover the region. Cells without a bound are halved first and in depth,
/// so that a pole is found fast. A region
/// without end is looked at as one cell.
double supremum_bound(const Region& region, const Effort& effort,
                      const std::function<CellBounds(const Cell&)>& bounds);

}  // namespace analysis
