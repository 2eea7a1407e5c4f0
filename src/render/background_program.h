// SPDX-License-Identifier: MIT
// The program for the pixels around the bounds of a scene.
#pragma once

#include <optional>

#include "render/program.h"

namespace render {

/// Keeps the last one: scenes with the same settings share it. As linking takes as long as it saves
/// in some frames, it waits for a second frame.
class BackgroundProgram {
public:
    /// The one that belongs to `program`; null if there is none, in the first frame that would have
    /// another one than before, and if the driver rejects it. A frame may be drawn in tiles:
    /// `first_tile` is true for one of them.
    const Program* of(const Gl& gl, const Program& program, bool first_tile);

private:
    std::optional<shader::BackgroundSource> source_;
    std::optional<Program> linked_;
    bool is_rejected_ = false;
};

}  // namespace render
