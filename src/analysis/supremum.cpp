// SPDX-License-Identifier: MIT
#include "analysis/supremum.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

namespace analysis {
namespace {

struct Entry {
    Cell cell;
    double upper = 0;
    int depth = 0;

    bool operator<(const Entry& other) const {
        return upper != other.upper ? upper < other.upper : depth < other.depth;
    }
};

}  // namespace

double supremum_bound(const Region& region, const Effort& effort,
                      const std::function<CellBounds(const Cell&)>& bounds) {
    // What is true everywhere holds there too; halves of infinity are no smaller.
    if (!std::isfinite(diameter(region))) return bounds(bounding_cell(region)).upper;
    std::priority_queue<Entry> queue;
    double lower = 0;
    int looked_at = 0;
    const auto look_at = [&](const Cell& whole, int depth) {
        const std::optional<Cell> cell = clip(region, whole);
        if (!cell) return;
        const CellBounds found = bounds(*cell);
        ++looked_at;
        if (contains(region, cell->middle())) lower = std::max(lower, found.lower);
        queue.push({*cell, found.upper, depth});
    };
    look_at(bounding_cell(region), 0);
    while (looked_at < effort.cells && !queue.empty()) {
        const Entry top = queue.top();
        if (top.upper <= lower * (1 + effort.tolerance)) break;
        if (top.upper == numeric::infinity && top.depth >= effort.depth) break;
        if (is_over(effort.budget)) break;
        queue.pop();
        for (const Cell& half : halves(top.cell)) look_at(half, top.depth + 1);
    }
    return queue.empty() ? 0 : queue.top().upper;
}

}  // namespace analysis
