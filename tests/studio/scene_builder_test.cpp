// SPDX-License-Identifier: MIT
// What the compiler's thread makes of documents, with a driver that only counts.
#include "studio/scene_builder.h"

#include <stdexcept>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "analysis/counted_budget.h"

namespace {

using studio::BuiltScene;
using studio::SceneBuilder;

bool never() { return false; }

scene::Document with_formula(std::string text) {
    scene::Document document;
    document.formula = std::move(text);
    return document;
}

/// Links nothing, and counts how often it was asked to.
struct FakeDriver {
    int links = 0;
    bool refuses = false;

    SceneBuilder::Link link() {
        return
            [this](const shader::ProgramSource&) -> base::Result<std::unique_ptr<render::Program>> {
                ++links;
                if (refuses) return base::error("the driver says no");
                return std::unique_ptr<render::Program>();
            };
    }
};

TEST(SceneBuilder, links_once_for_any_values_of_parameters) {
    FakeDriver driver;
    SceneBuilder builder(driver.link());
    scene::Document document = with_formula("param a = 1 in [0, 2]\na*x^2 + y^2 + z^2 = 1");
    auto first = builder.build(document, never);
    ASSERT_TRUE(first && first->field_numbers && first->parameters);
    EXPECT_EQ(first->parameters->at(0).name, "a");
    document.parameters["a"] = 1.5;
    auto second = builder.build(document, never);
    ASSERT_TRUE(second && second->field_numbers);
    EXPECT_EQ(driver.links, 1);
    EXPECT_EQ(builder.work_done().links, 1);
    EXPECT_EQ(builder.work_done().sources, 1);
    EXPECT_EQ(builder.work_done().analyses, 2);
    EXPECT_NE(*first->field_numbers, *second->field_numbers);
}

TEST(SceneBuilder, analyses_only_what_has_changed) {
    FakeDriver driver;
    SceneBuilder builder(driver.link());
    scene::Document document = with_formula("param a = 1 in [0, 2]\na*x^2 + y^2 + z^2 = 1");
    const auto first = builder.build(document, never);
    ASSERT_TRUE(first && first->field_numbers);
    EXPECT_EQ(builder.work_done().analyses, 1);
    document.lights[0].intensity = 2;
    document.settings.exposure = 3;
    document.settings.steps = 50;
    const auto second = builder.build(document, never);
    ASSERT_TRUE(second && second->field_numbers);
    EXPECT_EQ(*first->field_numbers, *second->field_numbers);
    EXPECT_EQ(builder.work_done().analyses, 1);
    EXPECT_EQ(driver.links, 1);
    document.bounds.half *= 2;
    const auto third = builder.build(document, never);
    ASSERT_TRUE(third && third->field_numbers);
    EXPECT_NE(*first->field_numbers, *third->field_numbers);
    EXPECT_EQ(builder.work_done().analyses, 2);
    EXPECT_EQ(driver.links, 1);
}

TEST(SceneBuilder, analyses_what_time_allows_first_and_the_rest_when_asked_again) {
    FakeDriver driver;
    SceneBuilder builder(driver.link());
    scene::Document document =
        with_formula("param a = 1 in [0, 2]\nexp(a*x^2) + y^4 + z^2 - x*y*z = 3");
    ASSERT_TRUE(builder.build(document, never));
    EXPECT_FALSE(builder.is_coarse());
    document.parameters["a"] = 1.5;
    const analysis::Budget frame = analysis::over_after(3);
    const auto moved = builder.build(document, never, &frame);
    ASSERT_TRUE(moved && moved->field_numbers);
    EXPECT_TRUE(builder.is_coarse());
    EXPECT_TRUE(moved->field_numbers->coarse);
    EXPECT_NE(moved->steps.find("coarse"), std::string::npos);
    // Given up for something more urgent: what there was stays.
    const analysis::Budget none = analysis::over_after(0);
    const auto same = builder.build(document, never, &none);
    ASSERT_TRUE(same && same->field_numbers);
    EXPECT_TRUE(builder.is_coarse());
    EXPECT_EQ(*same->field_numbers, *moved->field_numbers);
    const auto refined = builder.build(document, never);
    ASSERT_TRUE(refined && refined->field_numbers);
    EXPECT_FALSE(builder.is_coarse());
    EXPECT_EQ(refined->steps.find("coarse"), std::string::npos);
    EXPECT_NE(*refined->field_numbers, *moved->field_numbers);
    EXPECT_EQ(builder.work_done().analyses, 4);
    // As if there had been time at once, and nothing more is to do.
    SceneBuilder patient(driver.link());
    const auto at_once = patient.build(document, never);
    ASSERT_TRUE(at_once && builder.build(document, never));
    EXPECT_EQ(*refined->field_numbers, *at_once->field_numbers);
    EXPECT_EQ(builder.work_done().analyses, 4);
    EXPECT_EQ(builder.work_done().links, 1);
    EXPECT_EQ(builder.work_done().sources, 1);
}

TEST(SceneBuilder, keeps_the_last_good_scene_while_the_text_is_broken) {
    FakeDriver driver;
    SceneBuilder builder(driver.link());
    scene::Document document = with_formula("param a = 1 in [0, 2]\na*x^2 + y^2 + z^2 = 1");
    const auto good = builder.build(document, never);
    document.formula += " +";
    const auto broken = builder.build(document, never);
    ASSERT_TRUE(good && broken);
    EXPECT_TRUE(base::has_errors(broken->diagnostics));
    EXPECT_EQ(broken->text, document.formula);
    EXPECT_FALSE(broken->parameters);
    EXPECT_EQ(broken->field_numbers, good->field_numbers);
    // And its parameters still move it.
    document.parameters["a"] = 0.5;
    const auto moved = builder.build(document, never);
    ASSERT_TRUE(moved);
    EXPECT_NE(moved->field_numbers, good->field_numbers);
    EXPECT_EQ(driver.links, 1);
}

TEST(SceneBuilder, warns_of_what_is_proven_for_the_document_of_the_moment) {
    FakeDriver driver;
    SceneBuilder builder(driver.link());
    scene::Document document = with_formula("param d = 0 in [0, 9]\nx = d");
    const auto seen = builder.build(document, never);
    document.parameters["d"] = 9.0;
    const auto away = builder.build(document, never);
    document.bounds.half = glm::dvec3(20);
    const auto again = builder.build(document, never);
    ASSERT_TRUE(seen && away && again);
    EXPECT_TRUE(seen->diagnostics.empty());
    ASSERT_EQ(away->diagnostics.size(), 1u);
    EXPECT_EQ(away->diagnostics[0].message,
              "no part of the surface is in the bounds, the ball of radius 2 about the origin; "
              "change the bounds or the parameters");
    EXPECT_TRUE(again->diagnostics.empty());
}

TEST(SceneBuilder, links_again_for_another_effect) {
    FakeDriver driver;
    SceneBuilder builder(driver.link());
    scene::Document document = with_formula("x^2 + y^2 + z^2 = 1");
    ASSERT_TRUE(builder.build(document, never));
    document.settings.show_steps = true;
    ASSERT_TRUE(builder.build(document, never));
    EXPECT_EQ(driver.links, 2);
    document.settings.exposure = 2;
    ASSERT_TRUE(builder.build(document, never));
    EXPECT_EQ(driver.links, 2);
}

TEST(SceneBuilder, shows_what_the_driver_says_and_does_not_ask_it_again) {
    FakeDriver driver;
    SceneBuilder builder(driver.link());
    const auto good = builder.build(with_formula("x^2 + y^2 + z^2 = 1"), never);
    driver.refuses = true;
    for (int i = 0; i < 2; ++i) {
        const auto built = builder.build(with_formula("x^2 + y^2 + z^4 = 1"), never);
        ASSERT_TRUE(built);
        ASSERT_EQ(built->failures.size(), 1u);
        EXPECT_EQ(built->failures[0].message, "the driver says no");
        EXPECT_EQ(built->field_numbers.has_value(), good->field_numbers.has_value());
    }
    EXPECT_EQ(driver.links, 2);
}

TEST(SceneBuilder, leaves_a_superseded_document_and_comes_back_to_it) {
    FakeDriver driver;
    SceneBuilder builder(driver.link());
    const scene::Document document = with_formula("x^2 + y^2 + z^2 = 1");
    EXPECT_FALSE(builder.build(document, [] { return true; }));
    EXPECT_EQ(driver.links, 0);
    EXPECT_TRUE(builder.build(document, never));
    EXPECT_EQ(driver.links, 1);
}

TEST(SceneBuilder, reports_an_exception_as_a_failure) {
    SceneBuilder builder(
        [](const shader::ProgramSource&) -> base::Result<std::unique_ptr<render::Program>> {
            throw std::runtime_error("out of luck");
        });
    const auto built = builder.build(with_formula("x^2 + y^2 + z^2 = 1"), never);
    ASSERT_TRUE(built);
    ASSERT_EQ(built->failures.size(), 1u);
    EXPECT_EQ(built->failures[0].message,
              "internal error while compiling: out of luck; change the formula");
}

}  // namespace
