// SPDX-License-Identifier: MIT
#include "render/brick_texture.h"

#include <utility>

namespace render {
namespace {

/// As shaders/brick/grid.glsl declares it.
constexpr GLuint unit = 5;

}  // namespace

BrickTexture::BrickTexture(BrickTexture&& other) noexcept : gl_(other.gl_) {
    *this = std::move(other);
}

BrickTexture& BrickTexture::operator=(BrickTexture&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    std::swap(sent_, other.sent_);
    return *this;
}

BrickTexture::~BrickTexture() {
    if (name_ != 0) gl_->DeleteTextures(1, &name_);
}

void BrickTexture::bind(const std::shared_ptr<const shader::BrickTexels>& bricks) {
    if (!bricks) return;
    const bool kept = sent_ && (sent_ == bricks || *sent_ == *bricks);
    if (!kept) {
        const int depth = bricks->side * bricks->grids;
        const bool fits = sent_ && sent_->side == bricks->side && sent_->grids == bricks->grids;
        if (!fits) {
            if (name_ != 0) gl_->DeleteTextures(1, &name_);
            gl_->CreateTextures(GL_TEXTURE_3D, 1, &name_);
            gl_->TextureStorage3D(name_, 1, GL_RG32F, bricks->side, bricks->side, depth);
            gl_->TextureParameteri(name_, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            gl_->TextureParameteri(name_, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        }
        gl_->TextureSubImage3D(name_, 0, 0, 0, 0, bricks->side, bricks->side, depth, GL_RG,
                               GL_FLOAT, bricks->texels.data());
        sent_ = bricks;
    }
    gl_->BindTextureUnit(unit, name_);
}

}  // namespace render
