// SPDX-License-Identifier: MIT
#include "render/depth_texture.h"

#include <limits>

#include "render/canvas.h"
#include "render/small_programs.h"

namespace {

using render_test::text;

class DepthTextureTest : public render_test::WithContext {};

/// Writes what it is told of each pixel.
shader::ProgramSource told() {
    shader::ProgramSource source =
        render_test::program("out_geometry = texelFetch(told, ivec2(gl_FragCoord.xy), 0);");
    const std::size_t place = source.fragment.find("layout(location = 0)");
    source.fragment.insert(place, "layout(binding = 0) uniform sampler2D told;\n");
    return source;
}

TEST_F(DepthTextureTest, tells_each_pixel_its_own_depth_bit_for_bit) {
    image::Grey depth(37, 23);
    for (std::size_t i = 0; i < depth.values.size(); ++i) {
        depth.values[i] = 1.0F / static_cast<float>(i + 3);
    }
    *depth.at(5, 2) = std::numeric_limits<float>::infinity();
    const auto texture = render::DepthTexture::create(context->gl(), depth);
    ASSERT_TRUE(texture) << text(texture);
    auto canvas = render::Canvas::create(context->gl(), 37, 23, render_test::everything);
    ASSERT_TRUE(canvas) << text(canvas);
    const auto program = render::Program::link(context->gl(), told());
    ASSERT_TRUE(program) << text(program);
    texture->bind();
    canvas->draw(*program, render_test::frame_of(render::whole(37, 23)), {}, {0, 0, 37, 23});
    const auto drawn = canvas->read_geometry();
    for (int y = 0; y < 23; ++y)
        for (int x = 0; x < 37; ++x) ASSERT_EQ(drawn.at(x, y)[0], *depth.at(x, y));
}

TEST_F(DepthTextureTest, refuses_what_the_driver_cannot_hold) {
    image::Grey depth;
    depth.width = 1 << 20;
    depth.height = 1;
    depth.values.resize(1 << 20);
    EXPECT_EQ(text(render::DepthTexture::create(context->gl(), depth)),
              "the driver cannot take the depths of 1048576x1 pixels; measure a smaller picture\n");
}

}  // namespace
