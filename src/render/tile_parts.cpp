// SPDX-License-Identifier: MIT
#include "render/tile_parts.h"

#include <utility>

#include "shader/program_source.h"

namespace render {
namespace {

constexpr int side = shader::tile_side;
/// As shaders/prepass/part.glsl says.
constexpr GLuint texture_unit = 1;

/// The most tiles that so many pixels can lie in.
int most_tiles(int pixels) { return (pixels + side - 2) / side + 1; }

}  // namespace

TileParts::TileParts(const Gl& gl, int width, int height)
    : gl_(&gl), width_(most_tiles(width)), height_(most_tiles(height)) {
    gl.CreateTextures(GL_TEXTURE_2D, 1, &texture_);
    gl.TextureStorage2D(texture_, 1, GL_RGBA32F, width_, height_);
    gl.TextureParameteri(texture_, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TextureParameteri(texture_, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.CreateFramebuffers(1, &framebuffer_);
    gl.NamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, texture_, 0);
}

TileParts::TileParts(TileParts&& other) noexcept { *this = std::move(other); }

TileParts& TileParts::operator=(TileParts&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    std::swap(framebuffer_, other.framebuffer_);
    std::swap(texture_, other.texture_);
    return *this;
}

TileParts::~TileParts() {
    if (!gl_) return;
    gl_->DeleteFramebuffers(1, &framebuffer_);
    gl_->DeleteTextures(1, &texture_);
}

Tile TileParts::texels(const Tile& part, int x, int y) {
    const int left = (x + part.x) / side, top = (y + part.y) / side;
    const int right = (x + part.x + part.width - 1) / side;
    const int bottom = (y + part.y + part.height - 1) / side;
    return {left - x / side, top - y / side, right - left + 1, bottom - top + 1};
}

void TileParts::target(const Tile& texels) const {
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    gl_->Viewport(0, 0, width_, height_);
    gl_->Scissor(texels.x, texels.y, texels.width, texels.height);
}

void TileParts::bind() const { gl_->BindTextureUnit(texture_unit, texture_); }

}  // namespace render
