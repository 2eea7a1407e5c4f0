// SPDX-License-Identifier: MIT
// What is drawn where, into which of the outputs, and what is refused.
#include "render/canvas.h"

#include <limits>
#include <utility>
#include <vector>

#include "render/small_programs.h"

namespace {

using render::Canvas;
using render::Program;
using render_test::everything;
using render_test::picture_only;
using render_test::text;

class CanvasTest : public render_test::WithContext {
protected:
    Canvas make_canvas(int width, int height, const shader::Outputs& outputs) {
        auto canvas = Canvas::create(context->gl(), width, height, outputs);
        EXPECT_TRUE(canvas) << text(canvas);
        return std::move(*canvas);
    }
    Program make_program(const shader::ProgramSource& source) {
        auto program = Program::link(context->gl(), source);
        EXPECT_TRUE(program) << text(program);
        return std::move(*program);
    }
    std::string refusal(int width, int height) {
        return text(Canvas::create(context->gl(), width, height, everything));
    }
};

TEST_F(CanvasTest, row_0_is_the_top_and_column_0_the_left) {
    Canvas canvas = make_canvas(37, 23, everything);
    const Program program = make_program(render_test::coordinates());
    canvas.draw(program, render_test::frame_of(render::whole(37, 23)), {}, {0, 0, 37, 23});
    const image::Picture picture = canvas.read_picture();
    const auto geometry = canvas.read_geometry();
    ASSERT_EQ(picture.width, 37);
    ASSERT_EQ(picture.height, 23);
    for (int y = 0; y < 23; ++y)
        for (int x = 0; x < 37; ++x) {
            ASSERT_EQ(picture.at(x, y)[0], x);
            ASSERT_EQ(picture.at(x, y)[1], y);
            ASSERT_EQ(geometry.at(x, y)[0], static_cast<float>(x));
            ASSERT_EQ(geometry.at(x, y)[1], static_cast<float>(y));
        }
}

TEST_F(CanvasTest, a_tile_draws_its_pixels_and_no_others) {
    Canvas canvas = make_canvas(20, 10, picture_only);
    const render::Frame frame = render_test::frame_of(render::whole(20, 10));
    canvas.draw(make_program(render_test::program("out_picture = vec4(0, 0, 1, 1);")), frame, {},
                {0, 0, 20, 10});
    canvas.draw(make_program(render_test::program("out_picture = vec4(1, 0, 0, 1);")), frame, {},
                {3, 2, 5, 4});
    const image::Picture picture = canvas.read_picture();
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 20; ++x) {
            const bool in_tile = x >= 3 && x < 8 && y >= 2 && y < 6;
            ASSERT_EQ(picture.at(x, y)[0], in_tile ? 255 : 0) << x << "," << y;
            ASSERT_EQ(picture.at(x, y)[2], in_tile ? 0 : 255) << x << "," << y;
        }
}

TEST_F(CanvasTest, pixels_around_the_bounds_are_left_to_the_background_from_the_second_frame_on) {
    Canvas canvas = make_canvas(64, 64, picture_only);
    scene::Document document;
    document.bounds = {scene::Bounds::Shape::sphere, glm::dvec3(0), glm::dvec3(1)};
    scene::Camera camera;
    camera.eye = {0, 0, 5};
    camera.target = {0, 0, 0};
    const render::Frame frame = render::frame(document, camera, render::whole(64, 64));
    shader::ProgramSource source = render_test::program("out_picture = vec4(1, 0, 0, 1);");
    const shader::ProgramSource green = render_test::program("out_picture = vec4(0, 1, 0, 1);");
    const auto drawn = [&](const Program& program, int x, int y) {
        // In two tiles: a frame begins where its first one does.
        canvas.draw(program, frame, {}, {0, 0, 64, 32});
        canvas.draw(program, frame, {}, {0, 32, 64, 32});
        return canvas.read_picture().at(x, y)[1];
    };
    source.background = shader::BackgroundSource{green.vertex, green.fragment};
    const Program program = make_program(source);
    EXPECT_EQ(drawn(program, 0, 0), 0) << "nothing is linked in the first frame";
    EXPECT_EQ(drawn(program, 0, 0), 255);
    EXPECT_EQ(drawn(program, 63, 40), 255);
    EXPECT_EQ(drawn(program, 32, 32), 0);
    // One that the driver rejects is done without.
    source.background->fragment = "#version 450 core\nnonsense";
    const Program rejected = make_program(source);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(drawn(rejected, 0, 0), 0);
}

TEST_F(CanvasTest, outputs_go_to_their_own_textures) {
    Canvas canvas = make_canvas(3, 2, everything);
    const Program program =
        make_program(render_test::program("out_picture = vec4(0.2, 0.4, 0.6, 1);\n"
                                          "out_geometry = vec4(1.0 / 0.0, -2.5, 1e-30, "
                                          "-1);\nout_normal = vec4(0.1, 0.2, 0.3, 7e6);"));
    canvas.draw(program, render_test::frame_of(render::whole(3, 2)), {}, {0, 0, 3, 2});
    const image::Picture picture = canvas.read_picture();
    EXPECT_EQ(std::vector<int>(picture.at(2, 1), picture.at(2, 1) + 3),
              (std::vector<int>{51, 102, 153}));
    const auto geometry = canvas.read_geometry();
    EXPECT_EQ(std::vector<float>(geometry.at(2, 1), geometry.at(2, 1) + 4),
              (std::vector<float>{std::numeric_limits<float>::infinity(), -2.5f, 1e-30f, -1.0f}));
    const auto normal = canvas.read_normal();
    EXPECT_EQ(std::vector<float>(normal.at(0, 0), normal.at(0, 0) + 4),
              (std::vector<float>{0.1f, 0.2f, 0.3f, 7e6f}));
}

TEST_F(CanvasTest, outputs_that_are_not_asked_for_are_empty) {
    Canvas canvas = make_canvas(4, 4, {false, true, false, false});
    canvas.draw(make_program(render_test::coordinates()),
                render_test::frame_of(render::whole(4, 4)), {}, {0, 0, 4, 4});
    EXPECT_TRUE(canvas.read_picture().values.empty());
    EXPECT_TRUE(canvas.read_normal().values.empty());
    EXPECT_EQ(canvas.read_geometry().at(3, 1)[0], 3.0f);
    EXPECT_EQ(canvas.picture_texture(), 0u);
}

TEST_F(CanvasTest, the_frame_arrives_in_the_block_as_it_is_laid_out) {
    Canvas canvas = make_canvas(1, 1, everything);
    render::Frame frame = render_test::frame_of(render::whole(1, 1));
    frame.eye.w = 1;
    frame.background_bottom.x = 2;
    frame.light_direction[7].y = 3;
    frame.light_colour[0].z = 4;
    frame.material[15].w = 5;
    frame.material_shininess[0].x = 6;
    frame.material_shininess[15].w = 7;
    frame.march.z = 8;
    canvas.draw(make_program(render_test::program(
                    "out_geometry = vec4(eye.w, background_bottom.x, light_direction[7].y, "
                    "light_colour[0].z);\nout_normal = vec4(material[15].w, "
                    "material_shininess[0].x, material_shininess[15].w, march.z);")),
                frame, {}, {0, 0, 1, 1});
    EXPECT_EQ(canvas.read_geometry().values, (std::vector<float>{1, 2, 3, 4}));
    EXPECT_EQ(canvas.read_normal().values, (std::vector<float>{5, 6, 7, 8}));
}

TEST_F(CanvasTest, field_values_arrive_also_when_they_change_between_draws) {
    Canvas canvas = make_canvas(2, 1, {false, true, true, false});
    const Program program = make_program(
        render_test::program("out_geometry = field_values[0]; out_normal = field_values[1];"));
    const render::Frame frame = render_test::frame_of(render::whole(2, 1));
    canvas.draw(program, frame, {{1, 2, 3, 4, 5}, nullptr}, {0, 0, 1, 1});
    canvas.draw(program, frame, {{9, 8, 7, 6, 5, 4, 3, 2}, nullptr}, {1, 0, 1, 1});
    EXPECT_EQ(canvas.read_geometry().values, (std::vector<float>{1, 2, 3, 4, 9, 8, 7, 6}));
    EXPECT_EQ(canvas.read_normal().values, (std::vector<float>{5, 0, 0, 0, 5, 4, 3, 2}));
}

TEST_F(CanvasTest, state_left_by_others_does_not_reach_the_pixels) {
    const render::Gl& gl = context->gl();
    Canvas canvas = make_canvas(8, 8, everything);
    const Program program = make_program(render_test::waves());
    const render::Frame frame = render_test::frame_of(render::whole(8, 8));
    canvas.draw(program, frame, {}, {0, 0, 8, 8});
    const image::Picture expected = canvas.read_picture();

    for (GLenum capability : {GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_STENCIL_TEST,
                              GL_COLOR_LOGIC_OP, GL_RASTERIZER_DISCARD, GL_FRAMEBUFFER_SRGB})
        gl.Enable(capability);
    gl.BlendFunc(GL_DST_COLOR, GL_ONE);
    gl.BlendEquation(GL_MAX);
    gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    gl.Viewport(1, 1, 2, 2);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 8);
    canvas.draw(make_program(render_test::coordinates()), frame, {}, {0, 0, 8, 8});
    canvas.draw(program, frame, {}, {0, 0, 8, 8});
    EXPECT_EQ(canvas.read_picture(), expected);
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(CanvasTest, moving_hands_the_textures_on) {
    Canvas first = make_canvas(5, 4, picture_only);
    const GLuint texture = first.picture_texture();
    ASSERT_NE(texture, 0u);
    Canvas second = std::move(first);
    EXPECT_EQ(second.picture_texture(), texture);
    second = make_canvas(7, 3, picture_only);
    EXPECT_EQ(second.width(), 7);
    second.draw(make_program(render_test::coordinates()),
                render_test::frame_of(render::whole(7, 3)), {}, {0, 0, 7, 3});
    EXPECT_EQ(second.read_picture().at(6, 2)[0], 6);
}

TEST_F(CanvasTest, refuses_an_empty_size) {
    EXPECT_EQ(refusal(0, 10), "a picture of 0x10 pixels is empty; both sides must be at least 1\n");
    EXPECT_EQ(refusal(10, -3),
              "a picture of 10x-3 pixels is empty; both sides must be at least 1\n");
}

TEST_F(CanvasTest, refuses_a_size_above_the_drivers_maximum) {
    const int largest = context->largest_size();
    const std::string too_large = std::to_string(largest + 1);
    EXPECT_EQ(refusal(largest + 1, 1),
              too_large +
                  "x1 pixels are more than the driver can draw at once; neither side may be "
                  "above " +
                  std::to_string(largest) + "\n");
    EXPECT_EQ(refusal(1, largest + 1),
              "1x" + too_large +
                  " pixels are more than the driver can draw at once; neither side "
                  "may be above " +
                  std::to_string(largest) + "\n");
}

TEST_F(CanvasTest, an_error_that_was_there_before_is_not_taken_for_its_own) {
    context->gl().Enable(GL_TEXTURE_2D_ARRAY);
    EXPECT_TRUE(Canvas::create(context->gl(), 8, 8, everything));
}

}  // namespace
