// SPDX-License-Identifier: MIT
// A picture is the same to the last bit, whichever passes of it are taken from an earlier frame,
// and what is taken from there is not computed again.
#include "render/passes.h"
#include "headless.h"

#include <gtest/gtest.h>

#include "compile/compile.h"
#include "render/canvas.h"
#include "render_answers/shot.h"

namespace render_answers {
namespace {

constexpr shader::Outputs outputs{.picture = true, .geometry = true, .normal = true, .light = true};
constexpr int width = 75, height = 53;

/// A document's program, and all that its pictures need.
class Passes : public testing::Test {
protected:
    void SetUp() override {
        document = document_of(
            {"param r = 1\nsphere(r) \\ box(0.6) | x*y = z", sphere_bounds(2), camera({3, 2, 4})});
        auto opened = open_headless();
        ASSERT_TRUE(opened);
        context = std::move(*opened);
        auto understood = compile::compile_formula(document.formula);
        ASSERT_TRUE(understood);
        formula = std::move(*understood);
        source = compile::program_source(formula, document, outputs);
        auto linked = render::Program::link(context->gl(), source);
        ASSERT_TRUE(linked) << linked.problems()[0].message;
        program.emplace(std::move(*linked));
    }
    void TearDown() override { program.reset(); }

    render::Canvas canvas(int w = width, int h = height) {
        auto made = render::Canvas::create(context->gl(), w, h, outputs);
        EXPECT_TRUE(made);
        return std::move(*made);
    }
    void draw(render::Canvas& canvas, render::Pass first, const render::Canvas& kept) {
        const scene::Camera camera = scene::camera_of(document, double(width) / height);
        const render::Frame frame =
            render::frame(document, camera, render::whole(kept.width(), kept.height()));
        canvas.draw_from(first, kept, *program, frame,
                         compile::field_numbers(formula, source, document),
                         {0, 0, canvas.width(), canvas.height()});
        canvas.finish();
    }

    scene::Document document;
    compile::Formula formula;
    shader::ProgramSource source;
    std::unique_ptr<render::Context> context;
    std::optional<render::Program> program;
};

TEST_F(Passes, from_any_on_bring_the_same_picture) {
    render::Canvas fused = canvas(), kept = canvas();
    draw(kept, render::Pass::geometry, kept);
    document.lights[0].direction = {-0.3, 1, 0.2};
    document.materials[0].colour = {0.2, 0.9, 0.4};
    draw(fused, render::Pass::geometry, fused);
    EXPECT_NE(fused.read_picture(), kept.read_picture());
    draw(kept, render::Pass::light, kept);
    EXPECT_EQ(fused.read_picture(), kept.read_picture());
    EXPECT_EQ(fused.read_geometry(), kept.read_geometry());
    EXPECT_EQ(fused.read_normal(), kept.read_normal());

    document.settings.exposure = 1.7;
    draw(fused, render::Pass::geometry, fused);
    EXPECT_NE(fused.read_picture(), kept.read_picture());
    draw(kept, render::Pass::image, kept);
    EXPECT_EQ(fused.read_picture(), kept.read_picture());
}

TEST_F(Passes, that_are_left_out_do_not_see_what_has_changed) {
    render::Canvas kept = canvas();
    draw(kept, render::Pass::geometry, kept);
    const auto geometry = kept.read_geometry();
    document.parameters["r"] = 0.8;
    draw(kept, render::Pass::light, kept);
    EXPECT_EQ(kept.read_geometry(), geometry);
    const image::Picture lit = kept.read_picture();
    document.lights[0].direction = {-0.3, 1, 0.2};
    draw(kept, render::Pass::image, kept);
    EXPECT_EQ(kept.read_picture(), lit);
    draw(kept, render::Pass::geometry, kept);
    EXPECT_NE(kept.read_geometry(), geometry);
    EXPECT_NE(kept.read_picture(), lit);
}

TEST_F(Passes, of_a_smaller_picture_take_single_pixels_of_what_is_kept) {
    render::Canvas kept = canvas(), small = canvas(width / 3, height / 3);
    draw(kept, render::Pass::geometry, kept);
    draw(small, render::Pass::light, kept);
    const image::Picture whole = kept.read_picture(), part = small.read_picture();
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x) {
            const int left = static_cast<int>((x + 0.5) * width / part.width);
            const int top = static_cast<int>((y + 0.5) * height / part.height);
            ASSERT_TRUE(std::equal(part.at(x, y), part.at(x, y) + 3, whole.at(left, top)))
                << x << "," << y;
        }
}

}  // namespace
}  // namespace render_answers
