// SPDX-License-Identifier: MIT
// Which passes a change of a document asks for.
#include "render/passes.h"

#include <gtest/gtest.h>

#include <functional>
#include <utility>
#include <vector>

namespace {

using render::Pass;

render::Frame frame_of(const scene::Document& document) {
    return render::frame(document, scene::camera_of(document, 1.5), render::whole(60, 40));
}

/// The first pass that a change asks for.
std::optional<Pass> after(const std::function<void(scene::Document&)>& change) {
    scene::Document document;
    const render::Frame before = frame_of(document);
    change(document);
    return first_changed(before, frame_of(document));
}

TEST(FirstChanged, is_none_where_nothing_is_read_by_the_frame) {
    EXPECT_EQ(after([](auto&) {}), std::nullopt);
    EXPECT_EQ(after([](auto& d) { d.title = "another"; }), std::nullopt);
}

TEST(FirstChanged, of_the_exposure_is_the_image) {
    EXPECT_EQ(after([](auto& d) { d.settings.exposure = 2; }), Pass::image);
}

TEST(FirstChanged, of_what_shading_reads_is_the_light) {
    const std::vector<std::function<void(scene::Document&)>> changes{
        [](auto& d) {
            d.lights[0].direction = {-1, 1, 0};
        },
        [](auto& d) { d.lights[0].intensity = 2; },
        [](auto& d) { d.lights.clear(); },
        [](auto& d) { d.materials[0].colour.r = 0; },
        [](auto& d) { d.materials[0].shininess = 3; },
        [](auto& d) { d.materials.resize(3); },
        [](auto& d) { d.environment.sky.r = 1; },
        [](auto& d) { d.environment.ground.r = 1; },
        [](auto& d) { d.environment.background_top.g = 1; },
        [](auto& d) { d.environment.background_bottom.g = 1; },
        [](auto& d) { d.settings.shadow = 3; },
        [](auto& d) { d.settings.shadow = 3, d.settings.exposure = 2; },
    };
    for (std::size_t i = 0; i < changes.size(); ++i) EXPECT_EQ(after(changes[i]), Pass::light) << i;
}

TEST(FirstChanged, of_what_rays_read_is_the_geometry) {
    const std::vector<std::function<void(scene::Document&)>> changes{
        [](auto& d) {
            d.camera = scene::Camera{.eye = {0, 0, 9}};
        },
        [](auto& d) { d.bounds.half = glm::dvec3(5); },
        [](auto& d) { d.settings.steps = 9; },
        [](auto& d) { d.settings.lipschitz = 2; },
        [](auto& d) { d.settings.epsilon = 1; },
        [](auto& d) { d.settings.epsilon = 1, d.lights.clear(); },
    };
    for (std::size_t i = 0; i < changes.size(); ++i)
        EXPECT_EQ(after(changes[i]), Pass::geometry) << i;
}

}  // namespace
