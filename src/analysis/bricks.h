// SPDX-License-Identifier: MIT
// A region cut into bricks: which of them hold no surface for sure, and on which side they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "analysis/budget.h"
#include "analysis/region.h"
#include "field/field.h"

namespace analysis {

/// What is known of a brick, rigorously: of the real function and of its values in double.
enum class Brick : std::uint8_t {
    outside,  ///< nothing is in it, or it is outside of the region
    inside,   ///< in a solid all over, and no sheet is in it
    surface,  ///< it may hold a surface
};

/// A box cut into side^3 equal bricks. Of each brick all is known a little beyond its walls, too:
/// `margin` of its own size, so that a ray's rounded position tells its brick well enough.
struct BrickGrid {
    static constexpr double margin = 1.0 / 32;

    Cell box;
    int side = 1;

    std::size_t count() const;
    std::size_t place(glm::ivec3 at) const;
    glm::ivec3 at(std::size_t place) const;
    glm::dvec3 size() const { return (box.high - box.low) / static_cast<double>(side); }
    /// The brick with its margin.
    Cell widened(glm::ivec3 at) const;
};

struct Bricks {
    BrickGrid grid;
    std::vector<Brick> bricks;  ///< by BrickGrid::place

    Brick at(glm::ivec3 place) const { return bricks[grid.place(place)]; }
    /// How many of them are no `surface`.
    std::size_t decided() const;
};

/// How far bricks are cut, counted in work and not in time, so that the same is found on every
/// machine.
struct BrickEffort {
    int side = 16;  ///< at most; a power of two
    /// Operators over intervals in all, at most: where more would be needed, bricks stay as large
    /// as they are.
    std::size_t operations = 1'000'000;
    /// The same for bounds of derivatives (leaf_bricks).
    std::size_t jet_operations = 2'000'000;
    int threads = 1;  ///< does not change the result
    /// When it is over, bricks stay as large and as undecided as they are.
    const Budget* budget = nullptr;
};

/// The region with a little more around it, where a ray's rounded position may be.
Region padded(Region region);

/// Looks at the whole region first, and at the halves in each direction of what is not decided. A
/// brick stays undecided only where a surface may be in it or intervals are too wide to tell.
Bricks bricks(const field::Field& field, field::FieldId id, std::span<const double> parameters,
              const Region& region, const BrickEffort& effort);

}  // namespace analysis
