// SPDX-License-Identifier: MIT
// What a pre-pass writes: a texel for each tile of pixels.
#pragma once

#include "base/result.h"
#include "render/gl.h"

namespace render {

/// A part of a canvas, in pixels from its left and top.
struct Tile {
    int x = 0, y = 0, width = 0, height = 0;
};

/// A texture (RGBA32F) with a texel for each tile of 8x8 pixels that a canvas may have pixels of,
/// wherever in the full picture it lies, and the frame buffer to draw into it. Owns GL objects.
class TileParts {
public:
    TileParts(const Gl& gl, int width, int height);
    TileParts(TileParts&&) noexcept;
    TileParts& operator=(TileParts&&) noexcept;
    ~TileParts();

    /// The texels of the tiles that a part of the canvas has pixels of, where the canvas's pixel
    /// (0, 0) is the pixel (x, y) of the full picture.
    static Tile texels(const Tile& part, int x, int y);

    /// Makes the texture the target of drawing, these texels of it only.
    void target(const Tile& texels) const;
    /// For the program that reads it.
    void bind() const;

private:
    const Gl* gl_ = nullptr;
    int width_ = 0, height_ = 0;
    GLuint framebuffer_ = 0, texture_ = 0;
};

}  // namespace render
