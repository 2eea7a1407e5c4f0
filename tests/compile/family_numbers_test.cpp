// SPDX-License-Identifier: MIT
// What programs with families are fed with.
#include "compile/family_numbers.h"

#include <gtest/gtest.h>

#include <set>

#include "compile/precision.h"
#include "compile/understood.h"

namespace compile {
namespace {

/// Beads at places that repeat nowhere.
const std::string beads =
    "random(i, k) = mod(43758.5453 sin(12.9898i + 78.233k), 1)\n"
    "bead(i) = translate(sphere(0.05 + 0.02 random(i, 4)), (2random(i, 1) - 1, 2random(i, 2) - 1, "
    "2random(i, 3) - 1))\n";

std::shared_ptr<const std::vector<float>> texels(const std::string& text) {
    const Formula formula = understood(text);
    const scene::Document document;
    return field_numbers(formula, program_source(formula, document, {}), document).families;
}

TEST(FamilyNumbers, are_none_without_families) {
    EXPECT_EQ(texels("sphere(1)"), nullptr);
    EXPECT_EQ(texels(beads + "union(bead, 15)"), nullptr);
}

TEST(FamilyNumbers, of_a_thousand_members_are_some_megabytes) {
    for (const char* whole : {"union(bead, 1000)", "smooth_union(bead, 1000, 0.05)"}) {
        const auto made = texels(beads + whole);
        ASSERT_NE(made, nullptr) << whole;
        EXPECT_LT(made->size() * sizeof(float), 30e6) << whole;
    }
}

TEST(FamilyNumbers, begin_with_the_rows_of_all_members) {
    const Formula formula = understood(beads + "sphere(0.1) | x^2 <= y | union(bead, 20)");
    const scene::Document document;
    const shader::ProgramSource source = program_source(formula, document, {});
    ASSERT_EQ(source.families.size(), 1);
    const shader::FamilyTable& table = source.families[0];
    const auto made = field_numbers(formula, source, document).families;
    std::set<float> objects;
    for (std::size_t i = 0; i < table.members.size(); ++i) {
        objects.insert((*made)[4 * table.texels * (i + 1) - 1]);
    }
    // Each member has its own number, after those of the two before it.
    EXPECT_EQ(objects.size(), 20);
    EXPECT_EQ(*objects.begin(), 2);
    EXPECT_EQ(*objects.rbegin(), 21);
}

TEST(FamilyNumbers, are_of_the_world_in_programs_that_are_more_precise) {
    scene::Document document;
    document.camera = scene::Camera{{0, 0, 1.00001}, {0, 0, 1}};
    for (const char* whole : {"union(bead, 20)", "smooth_union(bead, 20, 0.05)"}) {
        EXPECT_EQ(choose_precision(understood(beads + whole), document).precision,
                  shader::Precision::doubled)
            << whole;
    }
    EXPECT_EQ(choose_precision(understood(beads + "bead(1)"), document).precision,
              shader::Precision::recentred);
}

}  // namespace
}  // namespace compile
