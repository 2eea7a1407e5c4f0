// SPDX-License-Identifier: MIT
// Facts of formulas as they are written, with answers that are known from elsewhere.
#include "analysis/facts.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/file.h"
#include "compile/understood.h"
#include "compile/visible_region.h"
#include "scene/preset.h"

namespace compile {
namespace {

using analysis::Metric;
using analysis::Reach;
using analysis::SceneFacts;
using analysis::Smoothness;

SceneFacts facts_of(std::string_view text, const scene::Document& document = {}) {
    const Formula formula = understood(text);
    return analysis::find_facts(formula.field, visible_region(document.bounds),
                                parameter_values(formula.field, document));
}

SceneFacts facts_of_preset(const std::string& name) {
    const auto path = std::filesystem::path(ZEROSET_SOURCE_DIR) / "presets" / (name + ".json");
    const auto text = base::read_text(path, scene::largest_preset);
    EXPECT_TRUE(text) << name;
    const auto preset = scene::read_preset(*text);
    EXPECT_TRUE(preset) << name;
    return facts_of(preset->document.formula, preset->document);
}

TEST(Facts, know_the_degrees_of_algebraic_surfaces) {
    for (const auto& [name, degree] :
         {std::pair{"barth_sextic", 6}, std::pair{"cayley_cubic", 3},
          std::pair{"chmutov_sextic", 6}, std::pair{"clebsch_cubic", 3}, std::pair{"decocube", 12},
          std::pair{"endrass_octic", 8}, std::pair{"kummer_quartic", 4},
          std::pair{"steiner_roman", 4}, std::pair{"tanglecube", 4},
          std::pair{"tetrahedral_cage", 4}, std::pair{"togliatti_quintic", 5}}) {
        const SceneFacts facts = facts_of_preset(std::string("algebraic/") + name);
        EXPECT_EQ(facts.whole.degree, degree) << name;
        EXPECT_EQ(facts.whole.regularity, (analysis::Regularity{Smoothness::smooth, false}))
            << name;
    }
}

TEST(Facts, of_a_sphere_by_its_equation) {
    const SceneFacts facts = facts_of("x^2 + y^2 + z^2 = 1");
    EXPECT_EQ(facts.whole.kind, field::Kind::sheet);
    EXPECT_EQ(facts.whole.degree, 2);
    EXPECT_EQ(facts.whole.metric, Metric::none);
    EXPECT_GE(facts.whole.lipschitz, 4);  // at the wall of the ball of radius 2
    EXPECT_LE(facts.whole.lipschitz, 4.5);
    EXPECT_EQ(facts.whole.reach, Reach::bounded);
    ASSERT_TRUE(facts.whole.box);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(facts.whole.box->low[i], -1, 0.01);
        EXPECT_NEAR(facts.whole.box->high[i], 1, 0.01);
    }
    EXPECT_EQ(facts.objects.size(), 1u);
}

TEST(Facts, of_objects_are_told_apart_from_those_of_the_scene) {
    const SceneFacts facts = facts_of("param d = 1\nsphere(1) | x*y <= d");
    ASSERT_EQ(facts.objects.size(), 2u);
    EXPECT_EQ(facts.objects[0].metric, Metric::exact);
    EXPECT_EQ(facts.objects[1].metric, Metric::none);
    EXPECT_EQ(facts.whole.metric, Metric::none);
    EXPECT_EQ(facts.objects[0].degree, std::nullopt);
    EXPECT_EQ(facts.objects[1].degree, 2);
    EXPECT_EQ(facts.whole.degree, std::nullopt);
    EXPECT_EQ(facts.objects[1].regularity.smoothness, Smoothness::smooth);
    EXPECT_EQ(facts.whole.regularity.smoothness, Smoothness::piecewise);
    EXPECT_EQ(facts.objects[0].reach, Reach::bounded);
    EXPECT_EQ(facts.objects[1].reach, Reach::open);
    EXPECT_FALSE(facts.objects[0].dependence.on_parameters());
    EXPECT_EQ(facts.objects[1].dependence.point, (std::array{true, true, false}));
    EXPECT_EQ(facts.whole.dependence.parameters.size(), 1u);
}

TEST(Facts, prove_that_a_gentle_formula_is_a_distance_bound) {
    EXPECT_EQ(facts_of("0.4*sin(x) + 0.3*y <= 0").whole.metric, Metric::bound);
    EXPECT_EQ(facts_of("sin(2x) <= 0").whole.metric, Metric::none);
    // The gradient is 0 wherever there is one.
    EXPECT_EQ(facts_of("floor(x) <= 0.5").whole.metric, Metric::none);
}

TEST(Facts, keep_distances_exact_through_motions) {
    EXPECT_EQ(facts_of("rotate(translate(box(), (1, 0, 0)), (0, 0, 1), 30)").whole.metric,
              Metric::exact);
    EXPECT_EQ(facts_of("complement(scale(torus(), 2))").whole.metric, Metric::exact);
    EXPECT_EQ(facts_of("smooth_union(sphere(), box(), 0.2)").whole.metric, Metric::bound);
}

TEST(Facts, depend_on_what_is_left_after_simplification) {
    const SceneFacts facts = facts_of("param a = 1\nparam b = 2\na^0*y^0 + b*x + z^0 = 0");
    EXPECT_EQ(facts.whole.dependence.point, (std::array{true, false, false}));
    EXPECT_EQ(facts.whole.dependence.parameters.size(), 1u);
}

TEST(Facts, of_nothing_and_of_everything) {
    EXPECT_FALSE(facts_of("x^2 + 1 = 0").whole.box);
    EXPECT_TRUE(facts_of("sphere(9)").whole.full);
}

TEST(Facts, of_an_object_in_cells_are_those_of_all_its_copies) {
    const SceneFacts facts =
        facts_of("repeat(sphere(0.25), (1, 0, 0), (3, 1, 1)) | box(0.1, 0.1, 0.1)");
    ASSERT_EQ(facts.objects.size(), 2u);
    const auto& copies = facts.objects[0];
    ASSERT_TRUE(copies.box);
    EXPECT_NEAR(copies.box->low.x, -1.25, 0.01);
    EXPECT_NEAR(copies.box->high.x, 1.25, 0.01);
    EXPECT_NEAR(copies.box->high.y, 0.25, 0.01);
    EXPECT_EQ(copies.metric, Metric::none);
    EXPECT_EQ(copies.regularity.smoothness, Smoothness::discontinuous);
    EXPECT_EQ(facts.objects[1].metric, Metric::exact);
}

TEST(Facts, of_an_object_in_cells_within_cells) {
    const SceneFacts facts = facts_of(
        "repeat(repeat(sphere(0.05), (0.2, 0, 0), (2, 1, 1)) | torus(0.1, 0.02), (1, 0, 0), "
        "(3, 1, 1))");
    ASSERT_EQ(facts.objects.size(), 2u);
    ASSERT_TRUE(facts.objects[0].box && facts.objects[1].box);
    EXPECT_NEAR(facts.objects[0].box->high.x, 1.15, 0.01);
    EXPECT_NEAR(facts.objects[1].box->high.x, 1.12, 0.01);
}

TEST(Facts, see_the_kinks_that_an_operation_makes) {
    const std::string halves = "f = iterate a = x for 2:\n    a = a/2\n    distance = a\n";
    const auto smoothness = [&](const std::string& text) {
        return facts_of(halves + text).whole.regularity.smoothness;
    };
    EXPECT_EQ(smoothness("f"), Smoothness::smooth);
    EXPECT_EQ(smoothness("complement(f)"), Smoothness::smooth);
    EXPECT_EQ(smoothness("offset(f, 0.1)"), Smoothness::smooth);
    EXPECT_EQ(smoothness("displace(f, 0.1*sin(y))"), Smoothness::smooth);
    EXPECT_EQ(smoothness("displace(f, 0.1*abs(y))"), Smoothness::piecewise);
    EXPECT_EQ(smoothness("shell(f, 0.1)"), Smoothness::piecewise);
    EXPECT_EQ(smoothness("f | y <= 0"), Smoothness::piecewise);
    EXPECT_EQ(smoothness("param a = 1\nif(a > 0, f, y <= 0)"), Smoothness::smooth);
}

TEST(Facts, count_nothing_that_only_a_lipschitz_constant_is_found_from) {
    const SceneFacts facts = facts_of(
        "param a = 3\nwave(p) = (p.x, p.y + sin(a*p.z), p.z)\n"
        "f = iterate w = x for 2:\n    w = w/2\n    distance = w\nmap(f, wave)");
    EXPECT_EQ(facts.whole.dependence.point, (std::array{true, false, false}));
    EXPECT_TRUE(facts.whole.dependence.parameters.empty());
    EXPECT_EQ(facts.whole.cost.point, 0u);
    EXPECT_EQ(facts.whole.cost.hoisted, 0u);
}

TEST(Facts, follow_escape_time_iterations) {
    const SceneFacts facts = facts_of("julia((0, 0, 0, 0), 6)");
    EXPECT_EQ(facts.whole.metric, Metric::estimate);
    EXPECT_EQ(facts.whole.regularity.smoothness, Smoothness::discontinuous);
    EXPECT_GT(facts.whole.cost.turn, 10u);
    // The unit ball, and a little more as the iteration is cut off.
    ASSERT_TRUE(facts.whole.box);
    for (int i = 0; i < 3; ++i) {
        EXPECT_LE(facts.whole.box->low[i], -1);
        EXPECT_GE(facts.whole.box->low[i], -1.5);
        EXPECT_GE(facts.whole.box->high[i], 1);
        EXPECT_LE(facts.whole.box->high[i], 1.5);
    }
}

}  // namespace
}  // namespace compile
