// SPDX-License-Identifier: MIT
#include "render/depth_texture.h"

#include <utility>

#include <fmt/format.h>

namespace render {

base::Result<DepthTexture> DepthTexture::create(const Gl& gl, const image::Grey& depth) {
    for (int i = 0; i < 16 && gl.GetError() != GL_NO_ERROR; ++i) continue;
    DepthTexture texture;
    texture.gl_ = &gl;
    gl.CreateTextures(GL_TEXTURE_2D, 1, &texture.name_);
    gl.TextureStorage2D(texture.name_, 1, GL_R32F, depth.width, depth.height);
    gl.TextureParameteri(texture.name_, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TextureParameteri(texture.name_, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TextureSubImage2D(texture.name_, 0, 0, 0, depth.width, depth.height, GL_RED, GL_FLOAT,
                         depth.values.data());
    if (gl.GetError() != GL_NO_ERROR) {
        return base::error(fmt::format(
            "the driver cannot take the depths of {}x{} pixels; measure a smaller picture",
            depth.width, depth.height));
    }
    return texture;
}

DepthTexture::DepthTexture(DepthTexture&& other) noexcept { *this = std::move(other); }

DepthTexture& DepthTexture::operator=(DepthTexture&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    return *this;
}

DepthTexture::~DepthTexture() {
    if (name_ != 0) gl_->DeleteTextures(1, &name_);
}

void DepthTexture::bind() const { gl_->BindTextureUnit(0, name_); }

}  // namespace render
