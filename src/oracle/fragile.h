// SPDX-License-Identifier: MIT
// Pixels whose answer hangs on a small part of a pixel.
#pragma once

#include "oracle/pixel_tracer.h"

namespace oracle {

/// Rays are moved by this part of a pixel.
inline constexpr double fragile_shift = 0.03;

/// Whether the answer may be another one close by: a neighbour has another verdict or object, or
/// the depth jumps or changes fast. The cheap test that comes first; heuristic.
bool may_be_fragile(const Reference& reference, int x, int y);

/// True if one of the four rays beside the pixel's own, which goes through the place (x, y), has
/// another verdict or object, or a depth that differs by more than half a footprint.
bool is_fragile(PixelTracer& trace, const Pixel& pixel, double x, double y, const Places& places,
                double pixel_width);

}  // namespace oracle
