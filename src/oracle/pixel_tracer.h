// SPDX-License-Identifier: MIT
// One pixel of the reference.
#pragma once

#include "oracle/first_hit.h"
#include "oracle/heuristic_march.h"
#include "oracle/surface.h"

namespace oracle {

/// A rectangle of pixels of the full picture.
struct Tile {
    int x = 0, y = 0, width = 0, height = 0;
};

/// Not for several threads.
class PixelTracer {
public:
    PixelTracer(const Shape& shape, const scene::Bounds& bounds, const Pinhole& pinhole);

    /// Where surfaces may be for all rays through a tile.
    Places places(const Tile& tile);
    /// The same for a part of the tile.
    Places places(const Tile& tile, const Places& around);
    /// What is seen at a place of the picture (Pinhole::through), in a tile of these places. Never
    /// fragile.
    Pixel operator()(double x, double y, const Places& places);

private:
    Beam beam(const Tile& tile) const;
    scene::Bounds bounds_;
    Pinhole pinhole_;
    FirstHit first_hit_;
    HeuristicMarch march_;
    SurfaceFinder surface_;
};

}  // namespace oracle
