// SPDX-License-Identifier: MIT
#include "analysis/holds_everywhere.h"

namespace analysis {

bool holds_everywhere(const Region& region, const Effort& effort,
                      const std::function<bool(const Cell&)>& holds) {
    // The supremum of something that is 0 where the statement holds: the search halves what is
    // unbounded first, and in depth.
    return supremum_bound(region, effort, [&](const Cell& cell) {
               return CellBounds{holds(cell) ? 0 : numeric::infinity, 0};
           }) == 0;
}

}  // namespace analysis
