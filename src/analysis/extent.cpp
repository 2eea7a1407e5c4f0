// SPDX-License-Identifier: MIT
#include "analysis/extent.h"

#include <array>
#include <queue>
#include <vector>

#include <glm/geometric.hpp>

#include "analysis/holds_everywhere.h"

namespace analysis {
namespace {

using numeric::infinity;
using numeric::Interval;

/// One of the six walls of a box: the least or the largest coordinate of an axis.
struct Wall {
    int axis = 0;
    bool low = true;

    double place(const Cell& cell) const { return low ? cell.low[axis] : cell.high[axis]; }
    /// How far the cell's own wall is outside, compared with others.
    double order(const Cell& cell) const { return low ? -place(cell) : place(cell); }
};

constexpr std::array walls{Wall{0, true},  Wall{1, true},  Wall{2, true},
                           Wall{0, false}, Wall{1, false}, Wall{2, false}};

struct Entry {
    Cell cell;
    double order = 0;
    int depth = 0;

    bool operator<(const Entry& other) const {
        return order != other.order ? order < other.order : depth < other.depth;
    }
};

/// Flat cells tell more about a wall: what lies below it is usually nearly parallel to it.
constexpr double flatness = 8;

double longest_side(const Cell& cell) {
    const int axis = longest_axis(cell);
    return cell.high[axis] - cell.low[axis];
}

int axis_to_halve(const Wall& wall, const Cell& cell) {
    const int longest = longest_axis(cell);
    const glm::dvec3 size = cell.high - cell.low;
    return size[longest] < flatness * size[wall.axis] ? wall.axis : longest;
}

/// Where this wall of the bounding box is: the outermost cell is halved or taken away until it is
/// small enough to tell. None if nothing is left.
std::optional<double> outermost(ContentFinder& content, const Region& region, const Wall& wall,
                                const Effort& effort) {
    const Cell whole = bounding_cell(region);
    const double small = effort.tolerance * longest_side(whole);
    std::priority_queue<Entry> queue;
    int looked_at = 0;
    const auto look_at = [&](const Cell& part, int depth) {
        const std::optional<Cell> cell = clip(region, part);
        if (!cell) return;
        ++looked_at;
        if (!content.over(*cell).proven_empty()) queue.push({*cell, wall.order(*cell), depth});
    };
    look_at(whole, 0);
    while (!queue.empty()) {
        const Entry top = queue.top();
        if (longest_side(top.cell) <= small || looked_at >= effort.cells) {
            return wall.place(top.cell);
        }
        queue.pop();
        for (const Cell& half : halves(top.cell, axis_to_halve(wall, top.cell))) {
            look_at(half, top.depth + 1);
        }
    }
    return std::nullopt;
}

std::array<Interval, 3> all_of_space() {
    return {Interval::whole(), Interval::whole(), Interval::whole()};
}

/// True if the six parts of space beyond the walls of the box are proven to hold nothing.
bool nothing_beyond(ContentFinder& content, const Cell& box) {
    for (const Wall& wall : walls) {
        std::array<Interval, 3> beyond = all_of_space();
        Interval& side = beyond[static_cast<std::size_t>(wall.axis)];
        side =
            wall.low ? Interval{-infinity, wall.place(box)} : Interval{wall.place(box), infinity};
        if (!content.over(beyond).proven_empty()) return false;
    }
    return true;
}

/// True if every point of the cell is in the region, and none on its walls.
bool strictly_inside(const Region& region, const Cell& cell) {
    const glm::dvec3 far =
        glm::max(glm::abs(cell.low - region.centre), glm::abs(cell.high - region.centre));
    constexpr double margin = 1 - 1e-9;
    if (region.sphere) return glm::length(far) < margin * region.half.x;
    return glm::all(glm::lessThan(far, margin * region.half));
}

/// True if nothing is at the walls of the region, proven.
bool nothing_at_walls(ContentFinder& content, const Region& region, const Effort& effort) {
    if (region.sphere) {
        return holds_everywhere(region, effort, [&](const Cell& cell) {
            return strictly_inside(region, cell) || content.over(cell).proven_empty();
        });
    }
    for (const Wall& wall : walls) {
        Region flat = region;
        flat.centre[wall.axis] += (wall.low ? -1 : 1) * region.half[wall.axis];
        flat.half[wall.axis] = 0;
        if (!proven_empty(content, flat, effort)) return false;
    }
    return true;
}

}  // namespace

bool proven_empty(ContentFinder& content, const Region& region, const Effort& effort) {
    return holds_everywhere(region, effort,
                            [&](const Cell& cell) { return content.over(cell).proven_empty(); });
}

bool proven_full(ContentFinder& content, const Region& region, const Effort& effort) {
    return holds_everywhere(region, effort,
                            [&](const Cell& cell) { return content.over(cell).proven_full(); });
}

bool proven_empty_everywhere(ContentFinder& content) {
    return content.over(all_of_space()).proven_empty();
}

bool proven_full_everywhere(ContentFinder& content) {
    return content.over(all_of_space()).proven_full();
}

std::optional<Cell> bounding_box(ContentFinder& content, const Region& region,
                                 const Effort& effort) {
    Cell box;
    for (const Wall& wall : walls) {
        const std::optional<double> place = outermost(content, region, wall, effort);
        if (!place) return std::nullopt;
        (wall.low ? box.low : box.high)[wall.axis] = *place;
    }
    return box;
}

Reach reach(ContentFinder& content, const Region& region, const Cell& box, const Effort& effort) {
    if (nothing_beyond(content, box)) return Reach::bounded;
    if (strictly_inside(region, box)) return Reach::contained;
    return nothing_at_walls(content, region, effort) ? Reach::contained : Reach::open;
}

}  // namespace analysis
