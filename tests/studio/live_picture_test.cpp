// SPDX-License-Identifier: MIT
// The picture in the window does no work whose result is there already.
#include "studio/live_picture.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "compile/compile.h"
#include "render/context.h"
#include "studio/live_outputs.h"

namespace {

using studio::LivePicture;
using studio::PictureWork;

constexpr int width = 64, height = 48;
constexpr long long pixels = width * height;

/// A picture of a formula, complete and at rest.
class LivePictureTest : public testing::Test {
protected:
    void SetUp() override {
        auto opened = render::open_osmesa();
        ASSERT_TRUE(opened);
        context = std::move(*opened);
        document.formula = "param r = 1 in [0, 2]\nsphere(r) | box(0.7)";
        auto understood = compile::compile_formula(document.formula);
        ASSERT_TRUE(understood);
        formula = std::move(*understood);
        source = compile::program_source(formula, document, studio::live_outputs);
        auto linked = render::Program::link(context->gl(), source);
        ASSERT_TRUE(linked) << linked.problems()[0].message;
        picture.emplace(context->gl());
        picture->set_program(std::make_unique<render::Program>(std::move(*linked)), now);
        draw_until_complete();
    }
    void TearDown() override { picture.reset(); }

    void draw_until_complete() {
        const scene::Camera camera = scene::camera_of(document, double(width) / height);
        picture->want(
            {document, camera, compile::field_numbers(formula, source, document), width, height},
            now);
        for (int i = 0; i < 1000 && picture->wait(now) < 10; ++i) {
            ASSERT_TRUE(picture->work(10, now));
            now += 0.1;
        }
        ASSERT_TRUE(picture->complete());
    }
    /// What drawing was done after a change of the document, until the picture was complete.
    PictureWork after(const std::function<void(scene::Document&)>& change) {
        const PictureWork before = picture->work_done();
        change(document);
        draw_until_complete();
        const PictureWork& now_done = picture->work_done();
        return {now_done.traced - before.traced, now_done.shaded - before.shaded,
                now_done.shown - before.shown};
    }

    double now = 1;
    scene::Document document;
    compile::Formula formula;
    shader::ProgramSource source;
    std::unique_ptr<render::Context> context;
    std::optional<LivePicture> picture;
};

TEST_F(LivePictureTest, draws_nothing_where_nothing_has_changed) {
    EXPECT_GE(picture->work_done().traced, pixels);
    EXPECT_EQ(after([](auto&) {}), PictureWork());
    EXPECT_EQ(after([](auto& d) { d.title = "another"; }), PictureWork());
}

TEST_F(LivePictureTest, traces_no_primary_ray_for_another_light_or_material) {
    for (const auto& change : std::vector<std::function<void(scene::Document&)>>{
             [](auto& d) {
                 d.lights[0].direction = {-1, 1, 0.5};
             },
             [](auto& d) { d.lights.push_back({}); },
             [](auto& d) {
                 d.materials[0].colour = {0.1, 0.9, 0.3};
             },
             [](auto& d) {
                 d.environment.background_top = {1, 1, 1};
             }}) {
        const PictureWork work = after(change);
        EXPECT_EQ(work.traced, 0);
        EXPECT_GE(work.shaded, pixels);
        EXPECT_EQ(work.shown, work.shaded);
    }
}

TEST_F(LivePictureTest, shades_nothing_for_another_exposure) {
    const PictureWork work = after([](auto& d) { d.settings.exposure = 2; });
    EXPECT_EQ(work.traced, 0);
    EXPECT_EQ(work.shaded, 0);
    EXPECT_GE(work.shown, pixels);
}

TEST_F(LivePictureTest, traces_again_where_the_surface_has_moved) {
    for (const auto& change : std::vector<std::function<void(scene::Document&)>>{
             [](auto& d) { d.parameters["r"] = 1.2; },
             [](auto& d) {
                 d.camera = scene::Camera{.eye = {0, 1, 5}};
             },
             [](auto& d) { d.settings.epsilon = 0.5; }}) {
        const PictureWork work = after(change);
        EXPECT_GE(work.traced, pixels);
        EXPECT_EQ(work.shaded, work.traced);
    }
}

TEST_F(LivePictureTest, traces_again_if_the_full_picture_was_not_complete) {
    document.parameters["r"] = 1.2;
    const scene::Camera camera = scene::camera_of(document, double(width) / height);
    picture->want(
        {document, camera, compile::field_numbers(formula, source, document), width, height}, now);
    const PictureWork work = after([](auto& d) { d.lights[0].intensity = 2; });
    EXPECT_GE(work.traced, pixels);
}

}  // namespace
