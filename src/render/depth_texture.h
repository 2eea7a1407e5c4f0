// SPDX-License-Identifier: MIT
// Depths that a program is told (shaders/tracer/told.glsl).
#pragma once

#include "base/result.h"
#include "image/image.h"
#include "render/gl.h"

namespace render {

/// One float a pixel, row 0 the top. Owns a GL object: its context must be current when it is made,
/// used and destroyed.
class DepthTexture {
public:
    /// Error: the driver has no room for it.
    static base::Result<DepthTexture> create(const Gl& gl, const image::Grey& depth);
    DepthTexture(DepthTexture&& other) noexcept;
    DepthTexture& operator=(DepthTexture&& other) noexcept;
    ~DepthTexture();

    /// Programs that are drawn from now on read this one.
    void bind() const;

private:
    DepthTexture() = default;

    const Gl* gl_ = nullptr;
    GLuint name_ = 0;
};

}  // namespace render
