// SPDX-License-Identifier: MIT
// The part of space that analyses look at, cut into boxes.
#pragma once

#include <array>
#include <optional>

#include <glm/vec3.hpp>

#include "numeric/interval.h"

namespace analysis {

/// A box, or the ball inscribed in it; world coordinates. For a ball `half` is the radius in every
/// component.
struct Region {
    glm::dvec3 centre{0};
    glm::dvec3 half{2};
    bool sphere = true;
};

/// A closed box by its corners.
struct Cell {
    glm::dvec3 low{0};
    glm::dvec3 high{0};

    std::array<numeric::Interval, 3> sides() const {
        return {numeric::Interval{low.x, high.x}, numeric::Interval{low.y, high.y},
                numeric::Interval{low.z, high.z}};
    }
    glm::dvec3 middle() const { return 0.5 * low + 0.5 * high; }
};

/// A cell that holds the whole region.
Cell bounding_cell(const Region& region);

/// The cell without what is outside of the region for sure: a box around their intersection, or
/// nothing.
std::optional<Cell> clip(const Region& region, const Cell& cell);

bool contains(const Region& region, glm::dvec3 point);

/// The longest straight way inside the region.
double diameter(const Region& region);

/// The axis of the cell's longest side.
int longest_axis(const Cell& cell);

/// Two cells that cover the cell, cut across the axis.
std::array<Cell, 2> halves(const Cell& cell, int axis);
/// The same across its longest side.
inline std::array<Cell, 2> halves(const Cell& cell) { return halves(cell, longest_axis(cell)); }

/// A point of the region, the same for the same number; the points of 0, 1, 2, ... fill it evenly.
glm::dvec3 spread_point(const Region& region, unsigned number);

}  // namespace analysis
