// SPDX-License-Identifier: MIT
#include "render/brick_texture.h"

#include "render/canvas.h"
#include "render/small_programs.h"

namespace {

using render_test::text;
using shader::BrickTexels;

class BrickTextureTest : public render_test::WithContext {
protected:
    /// What a program reads, brick by brick, on a canvas that stays.
    std::vector<float> read(const std::shared_ptr<const BrickTexels>& bricks) {
        canvas->draw(*program, {}, {{}, bricks}, {0, 0, 4, 4});
        const auto drawn = canvas->read_geometry();
        std::vector<float> texels;
        for (int i = 0; i < bricks->side * bricks->side * bricks->side * bricks->grids; ++i) {
            texels.push_back(drawn.at(i % 4, i / 4)[0]);
            texels.push_back(drawn.at(i % 4, i / 4)[1]);
        }
        return texels;
    }

    void SetUp() override {
        render_test::WithContext::SetUp();
        shader::ProgramSource source = render_test::program(
            "int i = int(gl_FragCoord.y) * 4 + int(gl_FragCoord.x);\n"
            "ivec3 size = textureSize(bricks, 0);\n"
            "out_geometry = texelFetch(bricks, ivec3(i % size.x, i / size.x % size.y, "
            "i / (size.x * size.y)), 0);");
        const std::size_t place = source.fragment.find("layout(location = 0)");
        source.fragment.insert(place, "layout(binding = 5) uniform sampler3D bricks;\n");
        auto linked = render::Program::link(context->gl(), source);
        ASSERT_TRUE(linked) << text(linked);
        program.emplace(std::move(*linked));
        auto made = render::Canvas::create(context->gl(), 4, 4, render_test::everything);
        ASSERT_TRUE(made) << text(made);
        canvas.emplace(std::move(*made));
    }

    std::optional<render::Program> program;
    std::optional<render::Canvas> canvas;
};

std::shared_ptr<const BrickTexels> counted(int side, int grids, float first) {
    BrickTexels bricks{side, grids, {}};
    for (int i = 0; i < 2 * side * side * side * grids; ++i) {
        bricks.texels.push_back(first + static_cast<float>(i));
    }
    return std::make_shared<const BrickTexels>(std::move(bricks));
}

TEST_F(BrickTextureTest, tells_the_bricks_that_belong_to_the_draw) {
    const auto one = counted(2, 1, 0.5F), two = counted(2, 2, -1e20F), other = counted(2, 1, 7);
    EXPECT_EQ(read(one), one->texels);
    EXPECT_EQ(read(other), other->texels) << "of the same size";
    EXPECT_EQ(read(two), two->texels) << "larger";
    EXPECT_EQ(read(one), one->texels) << "again";
}

}  // namespace
