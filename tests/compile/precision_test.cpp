// SPDX-License-Identifier: MIT
// In which numbers scenes are calculated.
#include "compile/precision.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "base/file.h"
#include "compile/understood.h"
#include "scene/preset.h"

namespace compile {
namespace {

using shader::Precision;

/// A view of the target from a distance.
scene::Document looking_at(const std::string& formula, glm::dvec3 target, double distance) {
    scene::Document document;
    document.formula = formula;
    document.bounds.centre = target;
    document.bounds.half = glm::dvec3(2 * distance);
    document.camera = scene::Camera{target + distance * glm::dvec3(0.4, 0.48, 0.78), target};
    return document;
}

Precision choice(const scene::Document& document) {
    return choose_precision(understood(document.formula), document).precision;
}

Precision choice(const std::string& formula, glm::dvec3 target, double distance) {
    return choice(looking_at(formula, target, distance));
}

TEST(Precision, is_single_for_every_preset_but_deep_zooms) {
    const std::filesystem::path folder = std::filesystem::path(ZEROSET_SOURCE_DIR) / "presets";
    int count = 0, zooms = 0;
    for (const std::filesystem::path& path : scene::list_presets(folder)) {
        const auto text = base::read_text(folder / path, scene::largest_preset);
        ASSERT_TRUE(text) << path;
        const auto preset = scene::read_preset(*text);
        ASSERT_TRUE(preset) << path;
        const bool zoom = path.filename().string().starts_with("zoom_");
        EXPECT_EQ(choice(preset->document), zoom ? Precision::doubled : Precision::single) << path;
        zooms += zoom;
        ++count;
    }
    EXPECT_GT(count, 50);
    EXPECT_GE(zooms, 3);
}

TEST(Precision, follows_a_zoom_into_a_formula_by_another_origin) {
    const std::string sphere = "x^2 + y^2 + z^2 = 1";
    EXPECT_EQ(choice(sphere, {0, 0, 1}, 3), Precision::single);
    EXPECT_EQ(choice(sphere, {0, 0, 1}, 1e-4), Precision::recentred);
    EXPECT_EQ(choice(sphere, {0, 0, 1}, 1e-9), Precision::recentred);
    EXPECT_EQ(choice("translate(sphere(1e-4), (1e4, 0, 0))", {1e4, 0, 0}, 3e-4),
              Precision::recentred);
}

TEST(Precision, follows_a_zoom_into_an_iteration_or_cells_by_doubles) {
    const std::string julia = "julia((-1, 0.2, 0, 0), 60)";
    EXPECT_EQ(choice(julia, {0.3, 0.2, 0.02}, 1), Precision::single);
    EXPECT_EQ(choice(julia, {0.3, 0.2, 0.02}, 1e-4), Precision::doubled);
    EXPECT_EQ(choice("repeat(sphere(1), (3, 3, 3))", {3, 0, 1}, 1e-5), Precision::doubled);
}

TEST(Precision, tells_why) {
    const scene::Document document = looking_at("julia()", {0, 0, 0}, 3);
    const std::string reason = choose_precision(understood(document.formula), document).reason;
    const std::string begin = "single precision moves the surface by ", end = " of a pixel";
    EXPECT_TRUE(reason.starts_with(begin)) << reason;
    EXPECT_TRUE(reason.ends_with(end)) << reason;
}

TEST(Precision, is_what_the_settings_say) {
    scene::Document document = looking_at("julia()", {0, 0, 0}, 1e-9);
    document.settings.precision = "single";
    EXPECT_EQ(choice(document), Precision::single);
    document = looking_at("julia()", {0, 0, 0}, 3);
    document.settings.precision = "double";
    EXPECT_EQ(choice(document), Precision::doubled);
}

TEST(Precision, is_in_the_program_and_its_numbers) {
    const scene::Document document = looking_at("(x - 1e4)^2 + y^2 + z^2 = 1", {1e4, 0, 1}, 1e-3);
    const Formula formula = understood(document.formula);
    const shader::ProgramSource source = program_source(formula, document, {});
    EXPECT_EQ(source.precision, Precision::recentred);
    const shader::FieldNumbers numbers = field_numbers(formula, source, document);
    EXPECT_EQ(numbers.origin, (std::array<double, 3>{1e4, 0, 1}));
    EXPECT_EQ(numbers.values.size(), source.field_values.size());
}

TEST(Precision, that_is_double_sends_no_cones_before_rays) {
    scene::Document document = looking_at("julia((-0.2, 0.6, 0.2, 0.2), 100)", {0, 0, 0}, 1);
    const Formula formula = understood(document.formula);
    EXPECT_FALSE(program_source(formula, document, {}).prepass.empty());
    document.settings.precision = "double";
    EXPECT_TRUE(program_source(formula, document, {}).prepass.empty());
}

TEST(Precision, is_chosen_anew_when_the_camera_is_elsewhere) {
    const scene::Document a = looking_at("x = 0", {0, 0, 1}, 1);
    EXPECT_TRUE(look_alike(a, looking_at("x = 0", {0, 0.1, 1}, 1.2)));
    EXPECT_FALSE(look_alike(a, looking_at("x = 0", {0, 0, 1}, 3)));
    EXPECT_FALSE(look_alike(a, looking_at("x = 0", {0, 0, 1}, 0.3)));
    EXPECT_FALSE(look_alike(a, looking_at("x = 0", {0, 0, 2}, 1)));
}

}  // namespace
}  // namespace compile
