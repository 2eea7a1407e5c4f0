// SPDX-License-Identifier: MIT
// A picture as a chain of passes, and what each of them reads of a frame.
#pragma once

#include <optional>

#include "render/frame.h"

namespace render {

/// In the order of the chain: what the primary rays meet; the light that comes from there; how a
/// display shows it. They are fused into one program, which can begin with any of them where the
/// results of those before are kept (Canvas::draw_from).
enum class Pass { geometry, light, image };

/// The first pass that reads something in which the frames differ, and so the first that must run
/// again; none: nothing must. The numbers of the field belong to the geometry as well.
std::optional<Pass> first_changed(const Frame& before, const Frame& now);

}  // namespace render
