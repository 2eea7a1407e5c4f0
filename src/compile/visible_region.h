// SPDX-License-Identifier: MIT
// The region that is looked at, as the analyses see it.
#pragma once

#include "analysis/region.h"
#include "scene/camera.h"

namespace compile {

/// The bounds; without any, the ball that is framed.
analysis::Region visible_region(const scene::Bounds& bounds);

}  // namespace compile
