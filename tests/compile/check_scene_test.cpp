// SPDX-License-Identifier: MIT
// Warnings that are proofs: their texts, and that no scene gets one that samples refute.
#include "compile/check_scene.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <random>

#include "analysis/region.h"
#include "base/file.h"
#include "compile/understood.h"
#include "compile/visible_region.h"
#include "eval/field_value.h"
#include "scene/preset.h"

namespace compile {
namespace {

using Shape = scene::Bounds::Shape;

std::string warning_of(std::string_view text, const scene::Document& document = {}) {
    const base::Diagnostics found = check_scene(understood(text), document);
    if (found.empty()) return "";
    EXPECT_EQ(found.size(), 1u) << text;
    EXPECT_EQ(found[0].severity, base::Severity::warning);
    return found[0].message;
}

scene::Document in_bounds(Shape shape, glm::dvec3 centre, glm::dvec3 half) {
    scene::Document document;
    document.bounds = {shape, centre, half};
    return document;
}

TEST(CheckScene, has_nothing_to_say_about_a_good_formula) {
    for (const char* text :
         {"x^2 + y^2 + z^2 = 1", "sphere(1)", "x = 0", "x <= 0", "sphere() | box()", "julia()",
          "mandelbulb()", "menger(3)", "box() \\ sphere(1.2)", "sphere(2) & abs(sin(9x)) <= 0.1",
          "x*y*z = 0", "sphere(1.999)"}) {
        EXPECT_EQ(warning_of(text), "") << text;
    }
}

TEST(CheckScene, tells_of_a_surface_that_is_nowhere) {
    EXPECT_EQ(warning_of("x^2 + y^2 + z^2 = -1"),
              "no point of space is on the surface; change the formula");
    EXPECT_EQ(warning_of("x^2 + 1 <= 0"), "no point of space is in the solid; change the formula");
    EXPECT_EQ(warning_of("param a = 2\nsin(x) = a"),
              "no point of space is on the surface; change the formula or the parameters");
    EXPECT_EQ(warning_of("sin(x) + 3 + t = 0"),
              "no point of space is on the surface; change the formula or the parameters");
    EXPECT_EQ(warning_of("x^2 + 1 = 0", in_bounds(Shape::none, {}, glm::dvec3(2))),
              "no point of space is on the surface; change the formula");
}

TEST(CheckScene, tells_of_a_scene_outside_of_the_bounds) {
    EXPECT_EQ(
        warning_of("translate(sphere(1), (5, 0, 0))"),
        "no part of the solid is in the bounds, the ball of radius 2 about the origin; change "
        "the bounds");
    EXPECT_EQ(warning_of("param d = 7\nx = d"),
              "no part of the surface is in the bounds, the ball of radius 2 about the origin; "
              "change the bounds or the parameters");
    EXPECT_EQ(warning_of("sphere(1)", in_bounds(Shape::box, {4, 0, 0}, {1, 2, 0.5})),
              "no part of the solid is in the bounds, the box of half extents (1, 2, 0.5) about "
              "(4, 0, 0); change the bounds");
    EXPECT_EQ(
        warning_of("translate(sphere(1), (5, 0, 0))", in_bounds(Shape::none, {}, glm::dvec3(2))),
        "");
}

TEST(CheckScene, tells_of_a_solid_that_fills_the_bounds) {
    EXPECT_EQ(
        warning_of("sphere(9)"),
        "the solid fills the bounds, the ball of radius 2 about the origin; widen the bounds, "
        "or cut something out of it");
    EXPECT_EQ(
        warning_of("x^2 + y^2 + z^2 >= -1"),
        "the solid fills the bounds, the ball of radius 2 about the origin; widen the bounds, "
        "or cut something out of it");
}

TEST(CheckScene, tells_of_a_formula_without_the_point) {
    const std::string text =
        "the formula does not depend on x, y or z, so that it holds everywhere or nowhere; use x, "
        "y or z";
    EXPECT_EQ(warning_of("1 < 2"), text);
    EXPECT_EQ(warning_of("param a = 1\na = 1"), text);
    EXPECT_EQ(warning_of("z^0 = 1"), text);
    EXPECT_EQ(warning_of("t <= 1"), text);
}

TEST(CheckScene, tells_of_comparisons_that_are_decided) {
    const std::string nowhere = "this comparison is true nowhere; change it, or take it away";
    const std::string everywhere = "this comparison is true everywhere; change it, or take it away";
    EXPECT_EQ(warning_of("sphere(1) | x^2 + y^2 = -1"), nowhere);
    EXPECT_EQ(warning_of("sphere(1) & x^2 >= -1"), everywhere);
    EXPECT_EQ(warning_of("sphere(1) & 1 < 2"), everywhere);
    EXPECT_EQ(warning_of("sphere(1) \\ (abs(z) < -0.1)"), nowhere);
    // A switch, and what only some values of a parameter decide.
    EXPECT_EQ(warning_of("param cut = on\nsphere(1) & cut > 0.5"), "");
    EXPECT_EQ(warning_of("param a = -1\nsphere(1) | x^2 <= a"), "");
    // Decided in the bounds only.
    EXPECT_EQ(warning_of("sphere(1) & z < 5"), "");
    // A function may be meant for other calls, too.
    EXPECT_EQ(warning_of("cut(a) = sphere(1) & x^2 >= a\ncut(-1) | cut(0.5)"), "");
    // A map or a blend may make another comparison of it.
    EXPECT_EQ(warning_of("square(p) = p.x*p\nsphere(1) \\ map(x <= -1, square)"), "");
    EXPECT_EQ(warning_of("sphere(1) | displace(x^2 + 0.1 <= 0, -z)"), "");
}

TEST(CheckScene, points_at_a_decided_comparison) {
    const base::Diagnostics found = check_scene(understood("sphere(1) & 0 <= x^2"), {});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].span, (base::SourceSpan{12, 20}));
}

TEST(CheckScene, uses_the_values_of_the_document) {
    const Formula formula = understood("param d = 0\nx = d + t");
    scene::Document document;
    EXPECT_TRUE(check_scene(formula, document).empty());
    document.time = 9;
    EXPECT_FALSE(check_scene(formula, document).empty());
}

TEST(CheckScene, points_at_the_last_expression) {
    const base::Diagnostics found = check_scene(understood("a = 3\nx = a"), {});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].span, (base::SourceSpan{6, 11}));
}

TEST(CheckScene, gives_up_where_a_point_is_enough_to_decide) {
    // A double root at a single point, and a pole.
    EXPECT_EQ(warning_of("(x - 0.3)^2 + (y - 0.7)^2 + (z - 0.1)^2 = 0"), "");
    EXPECT_EQ(warning_of("1/x = 0"), "");
}

TEST(CheckScene, of_random_formulas_is_never_refuted_by_samples) {
    constexpr unsigned seed = 20264;
    std::mt19937_64 random(seed);
    const auto number = [&](double size) {
        return std::to_string(std::uniform_real_distribution<double>(-size, size)(random));
    };
    const auto term = [&]() -> std::string {
        switch (random() % 6) {
            case 0:
                return "sin(" + number(4) + "*x + y)";
            case 1:
                return "abs(z - " + number(2) + ")";
            case 2:
                return "(x - " + number(2) + ")^2*" + number(1);
            case 3:
                return "y*z*" + number(2);
            case 4:
                return "exp(" + number(1) + "*z)";
            default:
                return "hypot(x - " + number(3) + ", y, z)";
        }
    };
    int warnings = 0;
    for (int round = 0; round < 600; ++round) {
        const bool sheet = random() % 2 == 0;
        const std::string text = term() + " + " + term() + (sheet ? " = " : " <= ") + number(6);
        const Formula formula = understood(text);
        const std::string warning = warning_of(text);
        if (warning.empty()) continue;
        ++warnings;
        const bool full = warning.find("fills") != std::string::npos;
        const analysis::Region region = visible_region({});
        int below = 0, above = 0;
        for (unsigned i = 0; i < 500; ++i) {
            const double value = eval::value(formula.field, formula.field.root,
                                             analysis::spread_point(region, i), {});
            below += value <= 0;
            above += value > 0;
        }
        // A surface needs both signs, a solid the right one: these formulas are continuous.
        if (sheet) {
            EXPECT_TRUE(below == 0 || above == 0) << "seed " << seed << ": " << text;
        } else {
            EXPECT_EQ(full ? above : below, 0) << "seed " << seed << ": " << text;
        }
    }
    EXPECT_GT(warnings, 60);
}

/// The contents of the fenced blocks of one kind in docs/language.md.
std::vector<std::string> blocks(const std::string& kind) {
    const auto text = base::read_text(
        std::filesystem::path(ZEROSET_SOURCE_DIR) / "docs/language.md", scene::largest_preset);
    EXPECT_TRUE(text);
    std::vector<std::string> list;
    const std::string fence = "\n```" + kind + "\n";
    for (std::size_t at = text->find(fence); at != std::string::npos; at = text->find(fence, at)) {
        at += fence.size();
        const std::size_t end = text->find("\n```", at);
        list.push_back(text->substr(at, end - at));
        at = end;
    }
    return list;
}

TEST(CheckScene, says_what_the_description_of_the_language_says) {
    const std::vector<std::string> reports = blocks("proven");
    EXPECT_GE(reports.size(), 2u);
    for (const std::string& report : reports) {
        // The second line is the formula.
        const std::size_t first = report.find('\n') + 1;
        const std::string text = report.substr(first, report.find('\n', first) - first);
        const base::Diagnostics found = check_scene(understood(text), {});
        ASSERT_EQ(found.size(), 1u) << text;
        EXPECT_EQ(base::format(found[0], "formula", text), report + "\n");
    }
    for (const std::string& example : blocks("zeroset")) {
        for (const base::Diagnostic& it : check_scene(understood(example), {})) {
            ADD_FAILURE() << example << '\n' << it.message;
        }
    }
}

TEST(CheckScene, has_nothing_to_say_about_the_shipped_presets) {
    const std::filesystem::path folder = std::filesystem::path(ZEROSET_SOURCE_DIR) / "presets";
    for (const auto& path : scene::list_presets(folder)) {
        const auto text = base::read_text(folder / path, scene::largest_preset);
        ASSERT_TRUE(text) << path;
        const auto preset = scene::read_preset(*text);
        ASSERT_TRUE(preset) << path;
        const Formula formula = understood(preset->document.formula);
        const auto start = std::chrono::steady_clock::now();
        EXPECT_TRUE(check_scene(formula, preset->document).empty()) << path;
        const std::chrono::duration<double, std::milli> taken =
            std::chrono::steady_clock::now() - start;
        std::cout << path.stem().string() << ": " << taken.count() << " ms\n";
    }
}

}  // namespace
}  // namespace compile
