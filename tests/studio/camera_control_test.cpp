// SPDX-License-Identifier: MIT
// The camera follows the mouse.
#include "studio/camera_control.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace {

const scene::Camera front{.eye = {0, 0, 5}, .target = {0, 0, 0}, .up = {0, 1, 0}, .fov = 45};

/// Where a point is seen: right and up, in parts of half the picture's height.
glm::dvec2 seen(const scene::Camera& camera, const glm::dvec3& point) {
    const scene::Axes axes = scene::axes(camera);
    const glm::dvec3 ray = point - camera.eye;
    const double k = std::tan(camera.fov / 2 * std::numbers::pi / 180) * glm::dot(ray, axes.w);
    return {glm::dot(ray, axes.u) / k, glm::dot(ray, axes.v) / k};
}

TEST(CameraControl, turns_the_front_of_the_scene_with_the_mouse) {
    const glm::dvec3 nearest(0, 0, 1);
    EXPECT_GT(seen(studio::drag_orbit(front, 50, 0, 600), nearest).x, 0.01);
    EXPECT_LT(seen(studio::drag_orbit(front, -50, 0, 600), nearest).x, -0.01);
    EXPECT_LT(seen(studio::drag_orbit(front, 0, 50, 600), nearest).y, -0.01);
    EXPECT_GT(seen(studio::drag_orbit(front, 0, -50, 600), nearest).y, 0.01);
}

TEST(CameraControl, turns_half_around_by_a_drag_of_the_picture_s_height) {
    const scene::Camera turned = studio::drag_orbit(front, 600, 0, 600);
    EXPECT_NEAR(turned.eye.z, -5, 1e-9);
    EXPECT_EQ(turned.target, front.target);
}

TEST(CameraControl, keeps_the_target_under_the_mouse_while_moving) {
    const scene::Camera moved = studio::drag_pan(front, 30, 60, 600);
    // 30 of 600 pixels are a tenth of half the height.
    EXPECT_NEAR(seen(moved, front.target).x, 0.1, 1e-9);
    EXPECT_NEAR(seen(moved, front.target).y, -0.2, 1e-9);
}

TEST(CameraControl, comes_nearer_by_the_wheel_and_goes_back_the_same_way) {
    const scene::Camera near = studio::wheel_dolly(front, 3);
    EXPECT_NEAR(near.eye.z, 5 * 0.9 * 0.9 * 0.9, 1e-9);
    EXPECT_NEAR(studio::wheel_dolly(near, -3).eye.z, 5, 1e-9);
}

}  // namespace
