// SPDX-License-Identifier: MIT
// What makes a reference useless, and what does not.
#include "studio/reference_key.h"

#include <gtest/gtest.h>

namespace {

using studio::reference_key;

const scene::Camera camera{.eye = {1, 2, 5}};

scene::Document document() {
    scene::Document result;
    result.formula = "param a = 1\nx^2 + y^2 + z^2 = a";
    return result;
}

TEST(ReferenceKey, stays_when_only_the_tracing_or_the_light_changes) {
    scene::Document changed = document();
    changed.settings = {.tracer = "sphere", .steps = 99, .lipschitz = 0.3, .epsilon = 5};
    changed.settings.shadows = !changed.settings.shadows;
    changed.lights.clear();
    changed.materials.emplace_back();
    changed.title = "another one";
    EXPECT_EQ(reference_key(changed, camera, 400, 300, 4),
              reference_key(document(), camera, 400, 300, 4));
}

TEST(ReferenceKey, changes_with_whatever_changes_the_surface_or_the_rays) {
    const auto key = reference_key(document(), camera, 400, 300, 4);
    const auto differs = [&](const scene::Document& changed) {
        return reference_key(changed, camera, 400, 300, 4) != key;
    };
    scene::Document changed = document();
    changed.formula += " + 1";
    EXPECT_TRUE(differs(changed));
    changed = document();
    changed.parameters["a"] = 2.0;
    EXPECT_TRUE(differs(changed));
    changed = document();
    changed.time = 0.5;
    EXPECT_TRUE(differs(changed));
    changed = document();
    changed.bounds.half.x = 3;
    EXPECT_TRUE(differs(changed));
    scene::Camera moved = camera;
    moved.fov += 1;
    EXPECT_NE(reference_key(document(), moved, 400, 300, 4), key);
    EXPECT_NE(reference_key(document(), camera, 401, 304, 4), key);
    EXPECT_NE(reference_key(document(), camera, 400, 300, 2), key);
}

TEST(ReferenceKey, has_the_part_of_the_sides_that_is_asked_for_and_at_least_a_pixel) {
    const auto quarter = reference_key(document(), camera, 403, 298, 4);
    EXPECT_EQ(quarter.width, 101);
    EXPECT_EQ(quarter.height, 75);
    const auto smallest = reference_key(document(), camera, 1, 3, 8);
    EXPECT_EQ(smallest.width, 1);
    EXPECT_EQ(smallest.height, 1);
    EXPECT_EQ(quarter.scene.camera, camera);
}

TEST(ReferenceKey, is_never_of_more_than_two_million_pixels) {
    const auto full = reference_key(document(), camera, 1920, 1000, 1);
    EXPECT_EQ(full.width, 1920);
    const auto less = reference_key(document(), camera, 3840, 2160, 1);
    EXPECT_EQ(less.width, 1920 / 2);
    EXPECT_EQ(less.height, 1080 / 2);
}

}  // namespace
