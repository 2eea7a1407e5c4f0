// SPDX-License-Identifier: MIT
// One pixel of the reference.
#pragma once

#include "oracle/first_hit.h"
#include "oracle/heuristic_march.h"
#include "oracle/surface.h"

namespace oracle {

/// Not for several threads.
class PixelTracer {
public:
    PixelTracer(const Shape& shape, const scene::Bounds& bounds, const Pinhole& pinhole);

    /// What is seen at a place of the picture (Pinhole::through). Never fragile.
    Pixel operator()(double x, double y);

private:
    scene::Bounds bounds_;
    Pinhole pinhole_;
    FirstHit first_hit_;
    HeuristicMarch march_;
    SurfaceFinder surface_;
};

}  // namespace oracle
