// SPDX-License-Identifier: MIT
// Where in a region a scene is, proven by taking away cells that hold nothing.
#pragma once

#include <optional>

#include "analysis/content.h"
#include "analysis/supremum.h"

namespace analysis {

/// True: a proof that no point of the region is on a sheet or in a solid.
bool proven_empty(ContentFinder& content, const Region& region, const Effort& effort);

/// True: a proof that every point of the region is in a solid.
bool proven_full(ContentFinder& content, const Region& region, const Effort& effort);

/// True: a proof that nothing is anywhere in space.
bool proven_empty_everywhere(ContentFinder& content);

/// True: a proof that every point of space is in a solid.
bool proven_full_everywhere(ContentFinder& content);

/// A box that holds all of the sheets and solids inside the region; none: there is nothing, proven.
/// Its walls are looked for one by one, each with this effort: up to `effort.tolerance` of the
/// region's size too far outside where that is enough, further where it is not.
std::optional<Cell> bounding_box(ContentFinder& content, const Region& region,
                                 const Effort& effort);

/// How far the scene goes on.
enum class Reach {
    bounded,    ///< proven: nothing is outside of the bounding box, anywhere in space
    contained,  ///< proven: nothing is at the walls of the region
    open,       ///< it may meet the walls of the region
};

/// `box` is the scene's bounding_box in the region.
Reach reach(ContentFinder& content, const Region& region, const Cell& box, const Effort& effort);

}  // namespace analysis
