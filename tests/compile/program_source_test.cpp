// SPDX-License-Identifier: MIT
// The settings of a document as features of a program.
#include <gtest/gtest.h>

#include <functional>

#include "compile/compile.h"
#include "compile/understood.h"

namespace compile {
namespace {

std::string fragment(const Formula& formula, const scene::Document& document) {
    return program_source(formula, document, {}).fragment;
}

TEST(ProgramSource, does_not_change_with_what_is_a_uniform) {
    const Formula formula = understood("param a = 0.5 in [0, 1]\nx^2 + a*y = z");
    const scene::Document before;
    const std::vector<std::function<void(scene::Document&)>> changes{
        [](auto& d) { d.parameters["a"] = 0.9; },       [](auto& d) { d.time = 3; },
        [](auto& d) { d.bounds.half = glm::dvec3(5); }, [](auto& d) { d.bounds.centre.x = 1; },
        [](auto& d) { d.camera = scene::Camera{}; },    [](auto& d) { d.lights.resize(2); },
        [](auto& d) { d.materials.resize(1); },         [](auto& d) { d.settings.steps = 9; },
        [](auto& d) { d.settings.lipschitz = 2; },      [](auto& d) { d.settings.epsilon = 1; },
        [](auto& d) { d.settings.shadow = 3; },         [](auto& d) { d.settings.exposure = 2; },
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
        scene::Document after = before;
        changes[i](after);
        EXPECT_EQ(fragment(formula, after), fragment(formula, before)) << "change " << i;
    }
}

TEST(ProgramSource, with_many_lights_or_materials_is_the_same_for_all_such_numbers) {
    const Formula formula = understood("x^2 + y = z");
    const scene::Document few;
    scene::Document many = few;
    many.lights.resize(3);
    const std::string text = fragment(formula, many);
    EXPECT_NE(text, fragment(formula, few));
    for (const std::size_t lights : {0, 1, 8}) {
        many.lights.resize(lights);
        many.materials.resize(lights == 8 ? 1 : 2);
        EXPECT_EQ(fragment(formula, many), text) << lights << " lights";
    }
}

TEST(ProgramSource, changes_with_every_switch) {
    const Formula formula = understood("x^2 + y = z");
    const scene::Document before;
    const std::vector<std::function<void(scene::Document&)>> changes{
        [](auto& d) { d.settings.tracer = "sphere"; },
        [](auto& d) { d.settings.shadows = !d.settings.shadows; },
        [](auto& d) { d.settings.grid = !d.settings.grid; },
        [](auto& d) { d.settings.show_steps = !d.settings.show_steps; },
        [](auto& d) { d.settings.show_certificate = !d.settings.show_certificate; },
        [](auto& d) { d.bounds.shape = scene::Bounds::Shape::box; },
        [](auto& d) { d.bounds.shape = scene::Bounds::Shape::none; },
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
        scene::Document after = before;
        changes[i](after);
        EXPECT_NE(fragment(formula, after), fragment(formula, before)) << "change " << i;
    }
}

TEST(ProgramSource, writes_the_outputs_that_are_asked_for) {
    const Formula formula = understood("x^2 + y = z");
    const std::string depth =
        program_source(formula, {}, {.picture = false, .geometry = true}).fragment;
    EXPECT_NE(depth.find("geometry_out"), std::string::npos);
    EXPECT_EQ(depth.find("picture_out"), std::string::npos);
}

}  // namespace
}  // namespace compile
