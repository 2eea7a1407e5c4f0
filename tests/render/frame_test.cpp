// SPDX-License-Identifier: MIT
// The numbers of the uniform block.
#include "render/frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace {

void expect_near(const glm::dvec4& actual, const glm::dvec3& xyz, double w) {
    EXPECT_NEAR(actual.x, xyz.x, 1e-6);
    EXPECT_NEAR(actual.y, xyz.y, 1e-6);
    EXPECT_NEAR(actual.z, xyz.z, 1e-6);
    EXPECT_NEAR(actual.w, w, 1e-6);
}

render::Frame frame_of(const scene::Document& document, const scene::Camera& camera = {}) {
    return render::frame(document, camera, render::whole(640, 480));
}

TEST(Frame, holds_the_cameras_axes) {
    scene::Camera camera;
    camera.eye = {3, -1, 2};
    camera.target = {0.5, 0.25, -1};
    camera.up = {0.1, 1, 0.2};
    camera.fov = 60;
    const render::Frame frame = frame_of({}, camera);
    const scene::Axes axes = scene::axes(camera);
    expect_near(frame.eye, camera.eye, std::tan(std::acos(-1.0) / 6));
    // A pixel at the distance 1, the steps as they are, and a part of a ball of radius 2.
    expect_near(frame.right, axes.u, 2 * std::tan(std::acos(-1.0) / 6) / 480);
    expect_near(frame.up, axes.v, 1);
    expect_near(frame.forward, axes.w, std::sqrt(12.0) / 64);
    // About the middle of the world, of which all is seen.
    expect_near(frame.origin, {0, 0, 0}, 1);
    EXPECT_NEAR(glm::length(glm::vec3(frame.forward)), 1, 1e-6);
}

TEST(Frame, holds_the_picture_and_the_place_of_the_region) {
    const render::Frame frame = render::frame({}, {}, {1000, 700, 30, 40, 50, 60});
    EXPECT_EQ(frame.picture, glm::dvec4(1000, 700, 30, 40));
}

TEST(Frame, knows_which_part_of_the_scene_is_looked_at_closely) {
    scene::Camera camera;
    camera.target = {1, 0, 0};
    camera.eye = {1, 0, 1e-3};
    EXPECT_NEAR(frame_of({}, camera).origin.w, 1e-3 / std::sqrt(12.0), 1e-12);
}

TEST(Frame, moves_to_another_origin_in_double_precision) {
    scene::Document document;
    document.bounds = {scene::Bounds::Shape::sphere, {1e4, 2, 0}, glm::dvec3(1)};
    scene::Camera camera;
    camera.eye = {1e4, 2, 1e-6};
    camera.target = {1e4, 2, 0};
    const render::Frame frame = about(frame_of(document, camera), {1e4, 2, 0});
    EXPECT_EQ(glm::dvec3(frame.eye), glm::dvec3(0, 0, 1e-6));
    EXPECT_EQ(glm::dvec3(frame.bounds_centre), glm::dvec3(0));
    EXPECT_EQ(frame.bounds_half.w, -1);  // the ground
    EXPECT_EQ(glm::dvec3(frame.origin), glm::dvec3(1e4, 2, 0));
}

TEST(Frame, whole_is_the_full_picture) {
    const render::View view = render::whole(12, 34);
    EXPECT_EQ(view.width, 12);
    EXPECT_EQ(view.height, 34);
    EXPECT_EQ(view.x, 0);
    EXPECT_EQ(view.y, 0);
    EXPECT_EQ(view.region_width, 12);
    EXPECT_EQ(view.region_height, 34);
}

TEST(Frame, rays_end_behind_the_farthest_point_of_a_sphere) {
    scene::Document document;
    document.bounds = {scene::Bounds::Shape::sphere, {1, 0, 0}, glm::dvec3(3)};
    scene::Camera camera;
    camera.eye = {11, 0, 0};
    const render::Frame frame = frame_of(document, camera);
    EXPECT_GT(frame.bounds_centre.w, 13);
    EXPECT_LT(frame.bounds_centre.w, 13.01);
    EXPECT_EQ(glm::vec3(frame.bounds_centre), glm::vec3(1, 0, 0));
    EXPECT_EQ(frame.bounds_half, glm::dvec4(3, 3, 3, -3));
}

TEST(Frame, rays_end_behind_the_farthest_corner_of_a_box) {
    scene::Document document;
    document.bounds = {scene::Bounds::Shape::box, {0, 5, 0}, {1, 2, 2}};
    scene::Camera camera;
    camera.eye = {-4, 1, -8};
    const double farthest = glm::distance(camera.eye, glm::dvec3(1, 7, 2));
    const render::Frame frame = frame_of(document, camera);
    EXPECT_GT(frame.bounds_centre.w, farthest);
    EXPECT_EQ(frame.bounds_half, glm::dvec4(1, 2, 2, 3));
}

TEST(Frame, without_bounds_rays_end_at_the_far_distance) {
    scene::Document document;
    document.bounds.shape = scene::Bounds::Shape::none;
    const render::Frame frame = frame_of(document);
    EXPECT_EQ(frame.bounds_centre.w, static_cast<float>(scene::far_distance));
    EXPECT_EQ(frame.bounds_half.w, -2.0f);
}

TEST(Frame, lights_are_unit_vectors_and_colours_times_intensity) {
    scene::Document document;
    document.lights = {{{0, 3, 4}, {1, 0.5, 0.25}, 2}, {{0, 0, 0}, {1, 1, 1}, 1}};
    const render::Frame frame = frame_of(document);
    EXPECT_EQ(frame.sky.w, 2.0f);
    expect_near(frame.light_direction[0], {0, 0.6, 0.8}, 0);
    expect_near(frame.light_colour[0], {2, 1, 0.5}, 0);
    expect_near(frame.light_direction[1], {0, 0, 0}, 0);
}

TEST(Frame, drops_lights_and_materials_beyond_the_maximum) {
    scene::Document document;
    document.lights.assign(render::max_lights + 3, scene::Light{});
    document.materials.assign(render::max_materials + 3, scene::Material{});
    const render::Frame frame = frame_of(document);
    EXPECT_EQ(frame.sky.w, static_cast<float>(render::max_lights));
    EXPECT_EQ(frame.ground.w, static_cast<float>(render::max_materials));
}

TEST(Frame, materials_are_repeated) {
    scene::Document document;
    document.materials.assign(3, scene::Material{});
    document.materials[1].colour = {0.25, 0.5, 1};
    document.materials[1].shininess = 7;
    const render::Frame frame = frame_of(document);
    EXPECT_EQ(frame.ground.w, 3.0f);
    for (std::size_t i = 0; i < render::max_materials; ++i) {
        EXPECT_EQ(frame.material[i], frame.material[i % 3]) << i;
        EXPECT_EQ(frame.material_shininess[i], frame.material_shininess[i % 3]) << i;
    }
    EXPECT_NE(frame.material[4], frame.material[3]);
    EXPECT_EQ(frame.material_shininess[4].x, 7.0f);
}

TEST(Frame, no_materials_means_one_by_default) {
    scene::Document document;
    document.materials.clear();
    const render::Frame frame = frame_of(document);
    EXPECT_EQ(frame.ground.w, 1.0f);
    expect_near(frame.material[0], scene::Material{}.colour, scene::Material{}.specular);
    EXPECT_EQ(frame.material_shininess[0].x, static_cast<float>(scene::Material{}.shininess));
}

TEST(Frame, holds_the_settings_and_the_environment) {
    scene::Document document;
    document.settings.steps = 77;
    document.settings.lipschitz = 1.5;
    document.settings.epsilon = 0.25;
    document.settings.shadow = 9;
    document.settings.exposure = 1.25;
    document.environment.sky = {1, 2, 3};
    document.environment.ground = {4, 5, 6};
    document.environment.background_top = {7, 8, 9};
    document.environment.background_bottom = {10, 11, 12};
    const render::Frame frame = frame_of(document);
    EXPECT_DOUBLE_EQ(frame_of(document).up.w, 1 / 1.5);
    EXPECT_EQ(frame.march, glm::dvec4(77, 1.5, 0.25, 9));
    EXPECT_EQ(frame.sky, glm::dvec4(1, 2, 3, 1));
    EXPECT_EQ(frame.ground, glm::dvec4(4, 5, 6, 1));
    EXPECT_EQ(frame.background_top, glm::dvec4(7, 8, 9, 1.25));
    EXPECT_EQ(frame.background_bottom, glm::dvec4(10, 11, 12, 0));
}

}  // namespace
