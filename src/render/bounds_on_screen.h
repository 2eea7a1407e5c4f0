// SPDX-License-Identifier: MIT
// Where on the screen the bounds of a scene are.
#pragma once

#include <vector>

#include "render/frame.h"
#include "render/tile_parts.h"

namespace render {

/// A tile in rectangles that do not overlap.
struct ScreenParts {
    std::vector<Tile> inside;   ///< all pixels whose rays meet the bounds, and more
    std::vector<Tile> outside;  ///< only pixels whose rays do not
};

/// In bands of rows. The bounds are those of the frame, a box or a sphere; `frame.passes` says how
/// many pixels of the full picture one of the tile is. Everything is inside where the eye is within
/// the bounds or not clearly before them.
ScreenParts bounds_on_screen(const Frame& frame, bool box, const Tile& tile);

}  // namespace render
