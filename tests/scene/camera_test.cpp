// SPDX-License-Identifier: MIT
// The camera against the rule of pixels that other programs rely on, and framing against geometry.
#include "scene/camera.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace {

using glm::dvec3;
using scene::Bounds;
using scene::Camera;

const double nan = std::numeric_limits<double>::quiet_NaN();

void expect_near(const dvec3& a, const dvec3& b, double tolerance = 1e-12) {
    EXPECT_LE(glm::length(a - b), tolerance)
        << a.x << ' ' << a.y << ' ' << a.z << " instead of " << b.x << ' ' << b.y << ' ' << b.z;
}

void expect_orthonormal(const scene::Axes& a) {
    EXPECT_NEAR(glm::length(a.u), 1, 1e-12);
    EXPECT_NEAR(glm::length(a.v), 1, 1e-12);
    EXPECT_NEAR(glm::length(a.w), 1, 1e-12);
    expect_near(glm::cross(a.u, a.w), a.v);
    EXPECT_NEAR(glm::dot(a.u, a.w), 0, 1e-12);
}

TEST(Axes, follow_the_rule_of_pixels) {
    const Camera camera{{3, -1, 2}, {0.5, 0.25, -1}, {0.1, 2, 0.3}, 30};
    const dvec3 w = glm::normalize(camera.target - camera.eye);
    const dvec3 u = glm::normalize(glm::cross(w, camera.up));
    const scene::Axes a = scene::axes(camera);
    expect_near(a.w, w);
    expect_near(a.u, u);
    expect_near(a.v, glm::cross(u, w));
}

TEST(Axes, of_the_simplest_camera_are_those_of_the_world) {
    const scene::Axes a = scene::axes({{0, 0, 5}, {0, 0, 0}});
    expect_near(a.u, {1, 0, 0});
    expect_near(a.v, {0, 1, 0});
    expect_near(a.w, {0, 0, -1});
}

TEST(Axes, take_z_as_up_where_up_is_parallel_to_the_view) {
    const scene::Axes down = scene::axes({{0.3, 5, 0.7}, {0.3, 0, 0.7}, {0, 1, 0}});
    expect_near(down.w, {0, -1, 0});
    expect_near(down.u, glm::normalize(glm::cross(dvec3(0, -1, 0), dvec3(0, 0, 1))));
    const scene::Axes zero = scene::axes({{0, 5, 0}, {0, 0, 0}, {0, 0, 0}});
    expect_near(zero.u, down.u);
}

TEST(Axes, take_x_as_up_where_the_view_is_parallel_to_z_as_well) {
    const scene::Axes a = scene::axes({{0, 0, 5}, {0, 0, 0}, {0, 0, -2}});
    expect_near(a.w, {0, 0, -1});
    expect_near(a.v, {1, 0, 0});
    expect_orthonormal(a);
}

TEST(Axes, are_usable_for_every_camera) {
    expect_orthonormal(scene::axes({}));
    expect_orthonormal(scene::axes({{nan, 0, 0}, {0, 0, 0}}));
    expect_orthonormal(scene::axes({{1, 2, 3}, {0, 0, 0}, {nan, nan, nan}}));
    expect_orthonormal(scene::axes({{1e300, 0, 0}, {-1e300, 0, 0}}));
}

/// How far from the centre the sphere's silhouette reaches, in parts of the way to the picture's
/// upper edge.
double silhouette(const Camera& camera, const dvec3& centre, double radius) {
    const double sine = radius / glm::length(camera.eye - centre);
    return std::tan(std::asin(sine)) / std::tan(camera.fov * std::acos(-1.0) / 360);
}

TEST(FrameAll, fills_the_picture_up_to_a_small_margin) {
    for (const double aspect : {0.2, 0.75, 1.0, 16.0 / 9, 4.0}) {
        for (const double fov : {10.0, 45.0, 120.0}) {
            const Bounds bounds{Bounds::Shape::sphere, {1, -2, 3}, dvec3(2.5)};
            const Camera camera = scene::frame_all(bounds, aspect, fov);
            EXPECT_NEAR(silhouette(camera, bounds.centre, 2.5), 0.96 * std::min(1.0, aspect), 1e-9)
                << "aspect " << aspect << ", fov " << fov;
            EXPECT_EQ(camera.target, bounds.centre);
            EXPECT_EQ(camera.fov, fov);
            expect_near(glm::normalize(camera.eye - camera.target),
                        glm::normalize(dvec3(1, 0.8, 1.6)));
        }
    }
}

TEST(FrameAll, takes_the_sphere_around_a_box) {
    const Bounds box{Bounds::Shape::box, {0, 0, 0}, {1, 2, 2}};
    const Bounds sphere{Bounds::Shape::sphere, {0, 0, 0}, dvec3(3)};
    EXPECT_EQ(scene::frame_all(box, 1.5), scene::frame_all(sphere, 1.5));
}

TEST(FrameAll, shows_every_corner_of_a_box) {
    const Bounds box{Bounds::Shape::box, {1, 0, -1}, {3, 0.5, 1}};
    const Camera camera = scene::frame_all(box, 1.6);
    const scene::Axes a = scene::axes(camera);
    const double k = std::tan(camera.fov * std::acos(-1.0) / 360);
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const dvec3 p = box.centre + sign * box.half - camera.eye;
        EXPECT_LT(std::abs(glm::dot(p, a.v)), k * glm::dot(p, a.w));
        EXPECT_LT(std::abs(glm::dot(p, a.u)), 1.6 * k * glm::dot(p, a.w));
    }
}

TEST(FrameAll, frames_no_bounds_like_the_sphere_of_radius_two) {
    const Bounds none{Bounds::Shape::none, {9, 9, 9}, dvec3(7)};
    EXPECT_EQ(scene::frame_all(none, 1.5), scene::frame_all(Bounds{}, 1.5));
}

TEST(FrameAll, survives_a_useless_aspect) {
    for (const double aspect : {0.0, -1.0, nan}) {
        EXPECT_EQ(scene::frame_all(Bounds{}, aspect), scene::frame_all(Bounds{}, 1));
    }
}

TEST(FrameFrom, keeps_direction_up_and_field_of_view) {
    const Camera camera{{4, 1, -3}, {1, 1, 1}, {0, 0, 1}, 70};
    const Bounds bounds{Bounds::Shape::sphere, {0, 5, 0}, dvec3(1)};
    const Camera framed = scene::frame_from(camera, bounds, 2);
    expect_near(scene::axes(framed).w, scene::axes(camera).w);
    EXPECT_EQ(framed.up, camera.up);
    EXPECT_EQ(framed.fov, camera.fov);
    EXPECT_EQ(framed.target, bounds.centre);
    EXPECT_NEAR(silhouette(framed, bounds.centre, 1), 0.96, 1e-9);
}

TEST(Orbit, turns_the_eye_to_the_right_and_up) {
    const Camera camera{{0, 0, 2}, {0, 0, 0}};
    const double quarter = std::acos(0.0);
    expect_near(scene::orbit(camera, quarter, 0).eye, {2, 0, 0});
    expect_near(scene::orbit(camera, 0, quarter / 3).eye,
                {0, 2 * std::sin(quarter / 3), 2 * std::cos(quarter / 3)});
    EXPECT_EQ(scene::orbit(camera, 0, 0), camera);
}

TEST(Orbit, keeps_target_up_and_distance) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-5, 5);
    for (int i = 0; i < 200; ++i) {
        const Camera camera{{number(random), number(random), number(random)},
                            {number(random), number(random), number(random)},
                            {number(random), number(random), number(random)}};
        const Camera turned = scene::orbit(camera, number(random), number(random));
        const double distance = glm::length(camera.eye - camera.target);
        EXPECT_NEAR(glm::length(turned.eye - turned.target), distance, 1e-9) << "draw " << i;
        EXPECT_EQ(turned.target, camera.target);
        EXPECT_EQ(turned.up, camera.up);
    }
}

TEST(Orbit, is_undone_by_the_opposite_turn) {
    const Camera camera{{1, 0.5, 2}, {0.2, 0, 0}};
    expect_near(scene::orbit(scene::orbit(camera, 0.4, 0.3), -0.4, -0.3).eye, camera.eye);
}

TEST(Orbit, stops_short_of_the_poles) {
    const Camera camera{{0, 0, 2}, {0, 0, 0}};
    for (const double pitch : {10.0, -10.0}) {
        const Camera turned = scene::orbit(camera, 0, pitch);
        EXPECT_GT(turned.eye.z, 0) << "it must not pass over the pole";
        EXPECT_NEAR(std::abs(turned.eye.y), 2, 0.001);
    }
}

TEST(Orbit, leaves_a_pole_without_turning_the_picture) {
    for (const double height : {3.0, -3.0}) {
        const Camera camera{{0, height, 0}, {0, 0, 0}};
        const Camera turned = scene::orbit(camera, 0, height > 0 ? -0.2 : 0.2);
        EXPECT_GT(glm::dot(scene::axes(turned).v, scene::axes(camera).v), 0.9) << height;
    }
}

TEST(Orbit, gives_a_camera_on_its_target_somewhere_to_stand) {
    const Camera turned = scene::orbit({{1, 1, 1}, {1, 1, 1}}, 0.3, 0.1);
    EXPECT_NEAR(glm::length(turned.eye - turned.target), 1, 1e-9);
}

TEST(Motion, ignores_what_is_not_finite) {
    const Camera camera{{1, 2, 3}, {0, 0, 0}};
    EXPECT_EQ(scene::orbit(camera, nan, 0), camera);
    EXPECT_EQ(scene::orbit(camera, 0, HUGE_VAL), camera);
    EXPECT_EQ(scene::pan(camera, nan, 0), camera);
    EXPECT_EQ(scene::dolly(camera, nan), camera);
    EXPECT_EQ(scene::dolly(camera, 0), camera);
    EXPECT_EQ(scene::dolly(camera, -2), camera);
}

TEST(Pan, moves_by_the_picture_at_the_target) {
    const Camera camera{{0, 0, 3}, {0, 0, 1}, {0, 1, 0}, 90};
    const Camera moved = scene::pan(camera, 0.5, 0.25);
    // At a distance of 2 the picture is 4 high.
    expect_near(moved.eye, {2, 1, 3});
    expect_near(moved.target, {2, 1, 1});
}

TEST(Dolly, multiplies_the_distance) {
    const Camera camera{{0, 0, 3}, {0, 0, 1}};
    expect_near(scene::dolly(camera, 0.5).eye, {0, 0, 2});
    expect_near(scene::dolly(camera, 3).eye, {0, 0, 7});
}

TEST(Dolly, never_reaches_the_target) {
    Camera camera{{0, 0, 3}, {0, 0, 1}};
    for (int i = 0; i < 500; ++i) camera = scene::dolly(camera, 0.01);
    EXPECT_NEAR(glm::length(camera.eye - camera.target), 1e-11, 1e-15);
    for (int i = 0; i < 500; ++i) camera = scene::dolly(camera, 100);
    EXPECT_NEAR(glm::length(camera.eye - camera.target), 1e6, 1);
}

}  // namespace
