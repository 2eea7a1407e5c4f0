// SPDX-License-Identifier: MIT
// Bounds of formulas brick by brick, where programs read them.
#pragma once

#include <memory>

#include "render/gl.h"
#include "shader/field_numbers.h"

namespace render {

/// A texture of three dimensions, kept until other bricks are asked for. Owns a GL object: its
/// context must be current when it is used and destroyed.
class BrickTexture {
public:
    explicit BrickTexture(const Gl& gl) : gl_(&gl) {}
    BrickTexture(BrickTexture&& other) noexcept;
    BrickTexture& operator=(BrickTexture&& other) noexcept;
    ~BrickTexture();

    /// For shaders/brick/grid.glsl. Sends the bricks if they are not those that were sent last;
    /// none leave the unit as it is.
    void bind(const std::shared_ptr<const shader::BrickTexels>& bricks);

private:
    const Gl* gl_;
    GLuint name_ = 0;
    std::shared_ptr<const shader::BrickTexels> sent_;
};

}  // namespace render
