// SPDX-License-Identifier: MIT
// Frame buffers, drawing into them, and reading them back.
#include "render/canvas.h"

#include <algorithm>
#include <array>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "render/bounds_on_screen.h"

namespace render {

namespace {

/// Binding points of the uniform blocks, as the shaders declare them.
constexpr GLuint frame_binding = 0;
constexpr GLuint values_binding = 1;
/// Texture units of what is kept: geometry, normal, light.
constexpr GLuint kept_unit = 2;
/// The texture unit of families.
constexpr GLuint families_unit = 6;

/// The most that is read back with one call: its size must fit a GLsizei.
constexpr long long most_bytes_read = 64LL << 20;

GLuint make_texture(const Gl& gl, GLenum format, int width, int height) {
    GLuint texture = 0;
    gl.CreateTextures(GL_TEXTURE_2D, 1, &texture);
    gl.TextureStorage2D(texture, 1, format, width, height);
    gl.TextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

base::Status check_size(const Gl& gl, int width, int height) {
    if (width <= 0 || height <= 0)
        return base::error(fmt::format(
            "a picture of {}x{} pixels is empty; both sides must be at least 1", width, height));
    GLint texture = 0;
    std::array<GLint, 2> viewport{};
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    const int largest = std::min({texture, viewport[0], viewport[1]});
    if (width > largest || height > largest)
        return base::error(
            fmt::format("{}x{} pixels are more than the driver can draw at once; neither side may "
                        "be above {}",
                        width, height, largest));
    return base::Done{};
}

void forget_errors(const Gl& gl) {
    // A lost context reports an error for ever, hence the bound.
    for (int i = 0; i < 16 && gl.GetError() != GL_NO_ERROR; ++i) continue;
}

template <class Number>
void upload_as(const Gl& gl, GLuint buffer, std::span<const double> numbers) {
    std::vector<Number> rounded(numbers.begin(), numbers.end());
    // A block holds whole vec4 and at least one of them.
    rounded.resize(std::max<std::size_t>(4, (rounded.size() + 3) / 4 * 4));
    // New storage each time: tiles that are still being drawn keep the old.
    gl.NamedBufferData(buffer, static_cast<GLsizeiptr>(rounded.size() * sizeof(Number)),
                       rounded.data(), GL_STREAM_DRAW);
}

/// The numbers of a uniform block, in the precision of the program.
void upload(const Gl& gl, GLuint buffer, std::span<const double> numbers, bool doubled) {
    if (doubled) {
        upload_as<double>(gl, buffer, numbers);
    } else {
        upload_as<float>(gl, buffer, numbers);
    }
}

std::span<const double> numbers_of(const Frame& frame) {
    static_assert(std::is_trivially_copyable_v<Frame> && sizeof(Frame) % sizeof(double) == 0);
    return {&frame.eye.x, sizeof(Frame) / sizeof(double)};
}

// What may be left over from other users of the context and would change the pixels.
void set_state(const Gl& gl) {
    for (GLenum capability :
         {GL_BLEND, GL_COLOR_LOGIC_OP, GL_CULL_FACE, GL_DEPTH_TEST, GL_DITHER, GL_FRAMEBUFFER_SRGB,
          GL_MULTISAMPLE, GL_RASTERIZER_DISCARD, GL_SAMPLE_MASK, GL_STENCIL_TEST})
        gl.Disable(capability);
    gl.Enable(GL_SCISSOR_TEST);
    // This blending changes nothing. But without any, llvmpipe compiles each fragment shader a
    // second time, for what no edge of a triangle crosses. Only the first target: others hold
    // infinities.
    gl.Enablei(GL_BLEND, 0);
    gl.BlendFunc(GL_ONE, GL_ZERO);
    gl.BlendEquation(GL_FUNC_ADD);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

// Reads rows in order, so the first row of the texture becomes the top of the image.
template <class Value, int Channels>
image::Image<Value, Channels> read(const Gl& gl, GLuint texture, int width, int height,
                                   GLenum format, GLenum type) {
    if (texture == 0) return {};
    image::Image<Value, Channels> image(width, height);
    const long long row_bytes = static_cast<long long>(width) * Channels * sizeof(Value);
    const int most_rows = static_cast<int>(std::max(1LL, most_bytes_read / row_bytes));
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int y = 0; y < height; y += most_rows) {
        const int rows = std::min(most_rows, height - y);
        gl.GetTextureSubImage(texture, 0, 0, y, 0, width, rows, 1, format, type,
                              static_cast<GLsizei>(row_bytes * rows), image.at(0, y));
    }
    return image;
}

}  // namespace

base::Result<Canvas> Canvas::create(const Gl& gl, int width, int height,
                                    const shader::Outputs& outputs) {
    if (auto size = check_size(gl, width, height); !size) return size.problems();
    forget_errors(gl);

    Canvas canvas;
    canvas.gl_ = &gl;
    canvas.bricks_.emplace(gl);
    canvas.width_ = width;
    canvas.height_ = height;
    gl.CreateFramebuffers(1, &canvas.framebuffer_);
    gl.CreateVertexArrays(1, &canvas.vertex_array_);
    gl.CreateBuffers(1, &canvas.frame_buffer_object_);
    gl.CreateBuffers(1, &canvas.values_buffer_object_);
    canvas.tile_parts_.emplace(gl, width, height);

    std::array<GLenum, 4> draw_buffers{GL_NONE, GL_NONE, GL_NONE, GL_NONE};
    const auto attach = [&](GLuint location, GLenum format) {
        const GLuint texture = make_texture(gl, format, width, height);
        const GLenum attachment = GL_COLOR_ATTACHMENT0 + location;
        gl.NamedFramebufferTexture(canvas.framebuffer_, attachment, texture, 0);
        draw_buffers[location] = attachment;
        return texture;
    };
    if (outputs.picture) canvas.picture_ = attach(0, GL_RGBA8);
    if (outputs.geometry) canvas.geometry_ = attach(1, GL_RGBA32F);
    if (outputs.normal) canvas.normal_ = attach(2, GL_RGBA32F);
    if (outputs.light) canvas.light_ = attach(3, GL_RGBA32F);
    gl.NamedFramebufferDrawBuffers(canvas.framebuffer_, draw_buffers.size(), draw_buffers.data());

    const GLenum problem = gl.GetError();
    if (problem == GL_OUT_OF_MEMORY)
        return base::error(fmt::format(
            "the driver has no memory for {}x{} pixels; draw a smaller picture", width, height));
    const GLenum status = gl.CheckNamedFramebufferStatus(canvas.framebuffer_, GL_DRAW_FRAMEBUFFER);
    if (problem != GL_NO_ERROR || status != GL_FRAMEBUFFER_COMPLETE)
        return base::error(
            fmt::format("the driver cannot make a frame buffer of {}x{} pixels (OpenGL error "
                        "{:#06x}, status {:#06x})",
                        width, height, problem, status));
    return canvas;
}

Canvas::Canvas(Canvas&& other) noexcept { *this = std::move(other); }

Canvas& Canvas::operator=(Canvas&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    std::swap(framebuffer_, other.framebuffer_);
    std::swap(vertex_array_, other.vertex_array_);
    std::swap(picture_, other.picture_);
    std::swap(geometry_, other.geometry_);
    std::swap(normal_, other.normal_);
    std::swap(light_, other.light_);
    std::swap(bricks_, other.bricks_);
    std::swap(background_, other.background_);
    std::swap(frame_buffer_object_, other.frame_buffer_object_);
    std::swap(values_buffer_object_, other.values_buffer_object_);
    std::swap(tile_parts_, other.tile_parts_);
    std::swap(families_buffer_object_, other.families_buffer_object_);
    std::swap(families_texture_, other.families_texture_);
    std::swap(families_, other.families_);
    return *this;
}

Canvas::~Canvas() {
    if (!gl_) return;
    for (GLuint* texture : {&picture_, &geometry_, &normal_, &light_, &families_texture_})
        gl_->DeleteTextures(1, texture);
    for (GLuint* buffer : {&frame_buffer_object_, &values_buffer_object_, &families_buffer_object_})
        gl_->DeleteBuffers(1, buffer);
    gl_->DeleteVertexArrays(1, &vertex_array_);
    gl_->DeleteFramebuffers(1, &framebuffer_);
}

int Canvas::width() const { return width_; }
int Canvas::height() const { return height_; }
GLuint Canvas::picture_texture() const { return picture_; }

/// Large, so handed over only when they have changed.
void Canvas::bind_families(const shader::FieldNumbers& numbers) {
    if (!numbers.families) return;
    const Gl& gl = *gl_;
    if (numbers.families != families_) {
        if (families_texture_ == 0) {
            gl.CreateBuffers(1, &families_buffer_object_);
            gl.CreateTextures(GL_TEXTURE_BUFFER, 1, &families_texture_);
        }
        families_ = numbers.families;
        gl.NamedBufferData(families_buffer_object_,
                           static_cast<GLsizeiptr>(families_->size() * sizeof(float)),
                           families_->data(), GL_STATIC_DRAW);
        gl.TextureBuffer(families_texture_, GL_RGBA32F, families_buffer_object_);
    }
    gl.BindTextureUnit(families_unit, families_texture_);
}

void Canvas::draw(const Program& program, const Frame& frame, const shader::FieldNumbers& numbers,
                  const Tile& tile) {
    draw_from(Pass::geometry, *this, program, frame, numbers, tile);
}

void Canvas::draw_from(Pass first, const Canvas& kept, const Program& program, const Frame& asked,
                       const shader::FieldNumbers& numbers, const Tile& tile) {
    const Gl& gl = *gl_;
    Frame own = about(asked, numbers.origin);
    own.passes = {static_cast<double>(first), static_cast<double>(kept.width_) / width_,
                  static_cast<double>(kept.height_) / height_, 0};
    upload(gl, frame_buffer_object_, numbers_of(own), program.doubled());
    upload(gl, values_buffer_object_, numbers.values, program.doubled());
    gl.BindBufferBase(GL_UNIFORM_BUFFER, frame_binding, frame_buffer_object_);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, values_binding, values_buffer_object_);
    bricks_->bind(numbers.bricks);

    bind_families(numbers);

    set_state(gl);
    gl.BindVertexArray(vertex_array_);
    if (program.prepass_name() != 0 && first == Pass::geometry) draw_tile_parts(program, own, tile);
    const GLuint textures[] = {kept.geometry_, kept.normal_, kept.light_};
    for (GLuint i = 0; i < std::size(textures); ++i) gl.BindTextureUnit(kept_unit + i, textures[i]);
    // A pixel may read its own texels of the target before it writes them, but not what is still
    // being written.
    gl.TextureBarrier();
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    gl.Viewport(0, 0, width_, height_);
    draw_pixels(program, own, tile);

    // Leave nothing behind that a user interface would trip over.
    gl.BindVertexArray(0);
    gl.UseProgram(0);
    gl.Disable(GL_SCISSOR_TEST);
    gl.Disable(GL_BLEND);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
}

/// Rays beside the bounds meet nothing: what is there does without the scene's program.
void Canvas::draw_pixels(const Program& program, const Frame& frame, const Tile& tile) {
    const auto draw = [&](const Program& with, const std::vector<Tile>& parts) {
        gl_->UseProgram(with.name());
        for (const Tile& part : parts) {
            gl_->Scissor(part.x, part.y, part.width, part.height);
            gl_->DrawArrays(GL_TRIANGLES, 0, 3);
        }
    };
    const Program* background = background_.of(*gl_, program, tile.x == 0 && tile.y == 0);
    if (!background) return draw(program, {tile});
    const ScreenParts parts = bounds_on_screen(frame, program.background()->bounds_box, tile);
    if (parts.outside.empty()) return draw(program, {tile});
    draw(program, parts.inside);
    draw(*background, parts.outside);
}

void Canvas::draw_tile_parts(const Program& program, const Frame& frame, const Tile& tile) {
    const auto x = static_cast<int>(frame.picture.z), y = static_cast<int>(frame.picture.w);
    tile_parts_->target(TileParts::texels(tile, x, y));
    gl_->UseProgram(program.prepass_name());
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
    tile_parts_->bind();
}

void Canvas::finish() { gl_->Finish(); }

image::Picture Canvas::read_picture() const {
    return read<std::uint8_t, 3>(*gl_, picture_, width_, height_, GL_RGB, GL_UNSIGNED_BYTE);
}

image::Image<float, 4> Canvas::read_geometry() const {
    return read<float, 4>(*gl_, geometry_, width_, height_, GL_RGBA, GL_FLOAT);
}

image::Image<float, 4> Canvas::read_normal() const {
    return read<float, 4>(*gl_, normal_, width_, height_, GL_RGBA, GL_FLOAT);
}

}  // namespace render
