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
    /// Heuristic: the same with all iterations by their estimates, which is faster, and stops
    /// where the ray passes a set by at less than a thousandth of a pixel.
    Pixel estimated(double x, double y, const Places& places);

private:
    Beam beam(const Tile& tile) const;
    Found estimated(const Ray& ray, const Stretch& stretch, double begin, const Places& places);
    Pixel seen(const Ray& ray, const Found& found, bool estimated);

    scene::Bounds bounds_;
    Pinhole pinhole_;
    FirstHit first_hit_;
    HeuristicMarch march_;
    SurfaceFinder surface_;
    bool is_heuristic_;  ///< so that all of its pixels are estimated
};

}  // namespace oracle
