// SPDX-License-Identifier: MIT
// The pre-pass: which tiles it is drawn for, and what the picture reads of it.
#include <tuple>
#include <utility>

#include "render/small_programs.h"
#include "render/still.h"

namespace {

using render::View;
using render_test::text;

/// The pre-pass writes each tile's number, counted in the full picture; the picture writes what it
/// reads at its pixel's tile into the geometry.
shader::ProgramSource numbered_tiles() {
    shader::ProgramSource source = render_test::program(
        "    vec2 tile = floor(pixel / 8.0) - floor(picture.zw / 8.0);\n"
        "    out_geometry = texelFetch(tile_parts, ivec2(tile), 0);");
    const std::string version = "#version 450 core\n";
    source.fragment.insert(version.size(), "layout(binding = 1) uniform sampler2D tile_parts;\n");
    source.prepass = render_test::preamble +
                     "void main() {\n"
                     "    vec2 tile = floor(gl_FragCoord.xy) + floor(picture.zw / 8.0);\n"
                     "    out_picture = vec4(tile, 8.0 * tile.x / picture.x, field_values[0].x);\n"
                     "}\n";
    return source;
}

class PrepassTest : public render_test::WithContext {
protected:
    /// Draws a view, and expects in each pixel the number of its tile.
    void expect_tiles(const View& view) {
        shader::FieldNumbers numbers;
        numbers.values = {0.625};
        shader::ProgramSource source = numbered_tiles();
        source.field_values.resize(1);
        const auto still = render::draw_still(*context, source, numbers, render_test::frame_of,
                                              view, {.picture = true, .geometry = true});
        ASSERT_TRUE(still) << text(still);
        for (int y = 0; y < view.region_height; ++y)
            for (int x = 0; x < view.region_width; ++x) {
                const float* pixel = still->geometry.at(x, y);
                const auto column = static_cast<float>((view.x + x) / 8);
                const auto row = static_cast<float>((view.y + y) / 8);
                ASSERT_EQ(std::tie(pixel[0], pixel[1]), std::tie(column, row)) << x << "," << y;
                ASSERT_FLOAT_EQ(pixel[2], 8 * column / static_cast<float>(view.width));
                ASSERT_EQ(pixel[3], 0.625F);
            }
    }
};

TEST_F(PrepassTest, every_pixel_reads_its_tile) {
    expect_tiles(render::whole(64, 40));
    expect_tiles(render::whole(61, 37));
    expect_tiles(render::whole(1, 1));
    expect_tiles(render::whole(9, 200));
}

TEST_F(PrepassTest, tiles_are_those_of_the_full_picture_wherever_a_region_lies) {
    for (int offset = 0; offset < 9; ++offset)
        for (int size : {1, 7, 8, 9, 16, 17})
            expect_tiles({123, 77, 5 + offset, 3 * offset, size, size + 2});
}

TEST_F(PrepassTest, pictures_larger_than_a_canvas_have_the_same_tiles) {
    expect_tiles(render::whole(2111, 35));
    expect_tiles({5000, 4100, 13, 2046, 3, 2053});
}

TEST_F(PrepassTest, a_part_of_a_canvas_draws_its_own_tiles_only) {
    const auto program = render::Program::link(context->gl(), numbered_tiles());
    ASSERT_TRUE(program) << text(program);
    EXPECT_NE(program->prepass_name(), 0u);
    auto canvas = render::Canvas::create(context->gl(), 50, 30, render_test::everything);
    ASSERT_TRUE(canvas) << text(canvas);
    const render::Frame first = render_test::frame_of({100, 100, 0, 0, 50, 30});
    const render::Frame second = render_test::frame_of({100, 100, 40, 40, 50, 30});
    canvas->draw(*program, first, {}, {0, 0, 50, 30});
    canvas->draw(*program, second, {}, {11, 9, 13, 5});
    const auto geometry = canvas->read_geometry();
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 50; ++x) {
            const bool again = x >= 11 && x < 24 && y >= 9 && y < 14;
            const int shift = again ? 40 : 0;
            ASSERT_EQ(geometry.at(x, y)[0], static_cast<float>((x + shift) / 8)) << x << "," << y;
            ASSERT_EQ(geometry.at(x, y)[1], static_cast<float>((y + shift) / 8)) << x << "," << y;
        }
}

TEST_F(PrepassTest, one_that_does_not_compile_is_an_error) {
    shader::ProgramSource source = numbered_tiles();
    source.prepass = "#version 450 core\nnonsense";
    const auto program = render::Program::link(context->gl(), source);
    ASSERT_FALSE(program);
    EXPECT_TRUE(text(program).starts_with("the OpenGL driver rejects the pre-pass shader:\n"))
        << text(program);
}

TEST_F(PrepassTest, both_programs_are_deleted_with_their_owner) {
    GLuint names[2];
    {
        const auto program = render::Program::link(context->gl(), numbered_tiles());
        ASSERT_TRUE(program) << text(program);
        names[0] = program->name();
        names[1] = program->prepass_name();
        for (const GLuint name : names) ASSERT_TRUE(context->gl().IsProgram(name));
    }
    for (const GLuint name : names) EXPECT_FALSE(context->gl().IsProgram(name));
}

}  // namespace
