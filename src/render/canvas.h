// SPDX-License-Identifier: MIT
// Textures that a program draws into, and reading them back.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "image/image.h"
#include "render/background_program.h"
#include "render/brick_texture.h"
#include "render/frame.h"
#include "render/gl.h"
#include "render/passes.h"
#include "render/program.h"
#include "render/tile_parts.h"
#include "shader/field_numbers.h"

namespace render {

/// A frame buffer with one texture per output. Row 0 of the textures is the top of the picture.
/// Owns GL objects: its context must be current when it is made, used and destroyed.
class Canvas {
public:
    /// RGBA8 for the picture, RGBA32F for geometry, normal and light, as far as they are asked for.
    /// What a size is refused for is said in the error.
    static base::Result<Canvas> create(const Gl& gl, int width, int height,
                                       const shader::Outputs& outputs);
    Canvas(Canvas&&) noexcept;
    Canvas& operator=(Canvas&&) noexcept;
    ~Canvas();

    int width() const;
    int height() const;
    /// The texture of the picture, for showing it.
    GLuint picture_texture() const;

    /// Draws one tile of the frame with this program, after its pre-pass for that tile, if it has
    /// one; asynchronous. The canvas's pixel (0, 0) is
    /// the full picture's pixel frame.picture.zw. Leaves the default frame buffer bound and the
    /// scissor test off.
    void draw(const Program& program, const Frame& frame, const shader::FieldNumbers& numbers,
              const Tile& tile);
    /// Draws a tile of the frame by the passes from `first` on. What those before would find is
    /// taken from a canvas that holds it for all of the same picture, this one or a larger one;
    /// `frame` is that canvas's. All canvases and the program must have all outputs.
    void draw_from(Pass first, const Canvas& kept, const Program& program, const Frame& frame,
                   const shader::FieldNumbers& numbers, const Tile& tile);
    /// Waits until everything drawn is there.
    void finish();

    /// What was drawn; waits for it. Empty where the canvas has no such texture.
    image::Picture read_picture() const;
    /// Depth, steps, status, object id.
    image::Image<float, 4> read_geometry() const;
    /// Normal, and evaluations where they are counted.
    image::Image<float, 4> read_normal() const;

private:
    Canvas() = default;
    void draw_tile_parts(const Program& program, const Frame& frame, const Tile& tile);
    void draw_pixels(const Program& program, const Frame& frame, const Tile& tile);

    void bind_families(const shader::FieldNumbers& numbers);

    const Gl* gl_ = nullptr;
    int width_ = 0, height_ = 0;
    GLuint framebuffer_ = 0, vertex_array_ = 0;
    GLuint picture_ = 0, geometry_ = 0, normal_ = 0, light_ = 0;
    std::optional<BrickTexture> bricks_;
    BackgroundProgram background_;
    GLuint frame_buffer_object_ = 0, values_buffer_object_ = 0;
    std::optional<TileParts> tile_parts_;  ///< always there in a canvas that can be drawn into
    GLuint families_buffer_object_ = 0, families_texture_ = 0;
    std::shared_ptr<const std::vector<float>> families_;  ///< what these hold
};

}  // namespace render
