// SPDX-License-Identifier: MIT
// What programs read of bricks.
#include "compile/brick_texels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "analysis/leaf_bricks.h"
#include "compile/understood.h"
#include "compile/visible_region.h"

namespace compile {
namespace {

const std::string steep = "exp(x^2 + y^2 + z^2) = 3 + x*y";

std::shared_ptr<const shader::BrickTexels> texels(const Formula& formula) {
    const scene::Document document;
    return field_numbers(formula, program_source(formula, document, {}), document).bricks;
}

TEST(BrickTexels, are_made_for_formulas_that_gain_by_them) {
    for (const char* text : {"y = 1/x", "y = exp(-x^2)", "(x*exp(y) <= 1) \\ (z*r >= 0.5)"}) {
        EXPECT_FALSE(understood(text).bricks.empty()) << text;
    }
    for (const char* text :
         {"x^2 + y^2 = 1", "x^6 + y^6 + z^6 = 1", "sin(x) + cos(y) = z", "sphere(1)", "menger(3)",
          "smooth_union(menger(2), exp(x) <= 1, 0.1)", "twist(box(1, 1, 1), z)"}) {
        const Formula formula = understood(text);
        EXPECT_TRUE(formula.bricks.empty()) << text;
        EXPECT_EQ(texels(formula), nullptr) << text;
    }
}

TEST(BrickTexels, are_of_the_default_tracer_only) {
    const Formula formula = understood(steep);
    scene::Document document;
    for (const shader::TracerName& tracer : shader::tracers()) {
        document.settings.tracer = tracer.name;
        const shader::ProgramSource source = program_source(formula, document, {});
        EXPECT_EQ(source.bricks.empty(), tracer.name != "auto") << tracer.name;
        EXPECT_EQ(source.fragment.find("zs_bricks") == std::string::npos, tracer.name != "auto");
    }
}

TEST(BrickTexels, hold_bounds_or_the_way_to_the_next_brick_with_a_surface) {
    const Formula formula = understood(steep);
    const auto made = texels(formula);
    const analysis::LeafBricks known = analysis::leaf_bricks(
        formula.field, formula.bricks[0], formula.tapes.formulas.at(formula.bricks[0]),
        parameter_values(formula.field, {}), visible_region(scene::Document{}.bounds), {});
    const analysis::BrickGrid& grid = known.bricks.grid;
    ASSERT_EQ(made->side, grid.side);
    ASSERT_EQ(made->texels.size(), 2 * grid.count());
    std::vector<glm::ivec3> surface;
    for (std::size_t i = 0; i < grid.count(); ++i) {
        if (known.bricks.bricks[i] == analysis::Brick::surface) surface.push_back(grid.at(i));
    }
    ASSERT_FALSE(surface.empty());
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const float inverse = made->texels[2 * i], second = made->texels[2 * i + 1];
        if (known.bricks.bricks[i] == analysis::Brick::surface) {
            EXPECT_LE(inverse, 1 / known.bounds[i].lipschitz);
            EXPECT_GT(inverse, 0.999 / known.bounds[i].lipschitz);
            EXPECT_GE(second, known.bounds[i].second_derivative);
            EXPECT_LT(second, 1.001 * known.bounds[i].second_derivative);
            continue;
        }
        int nearest = grid.side;
        for (const glm::ivec3& at : surface) {
            const glm::ivec3 way = glm::abs(at - grid.at(i));
            nearest = std::min(nearest, std::max({way.x, way.y, way.z}));
        }
        EXPECT_EQ(second, -nearest) << i;
    }
}

TEST(BrickTexels, say_where_nothing_of_a_scene_of_cells_is) {
    const Formula formula = understood("repeat(sphere(0.05), (1, 1, 1))");
    EXPECT_TRUE(formula.bricks.empty());
    const auto made = texels(formula);
    ASSERT_NE(made, nullptr);
    EXPECT_EQ(made->grids, 1);
    std::size_t empty = 0;
    for (std::size_t i = 0; i < made->texels.size(); i += 2) empty += made->texels[i + 1] < 0;
    EXPECT_GT(empty, made->texels.size() / 4);
    EXPECT_LT(empty, made->texels.size() / 2) << "the balls are somewhere";
}

TEST(BrickTexels, say_where_no_step_is_certified) {
    const auto made = texels(understood("y = 1/x"));
    int guesses = 0, certified = 0;
    for (std::size_t i = 0; i < made->texels.size(); i += 2) {
        guesses += made->texels[i] < 0;
        certified += made->texels[i] > 0 && made->texels[i + 1] > 0;
    }
    EXPECT_GT(guesses, 0);
    EXPECT_GT(certified, 100);
}

TEST(BrickTexels, have_a_grid_for_each_formula) {
    const Formula formula = understood("(x*exp(y) <= 1) | (y <= exp(x*z))");
    ASSERT_EQ(formula.bricks.size(), 2U);
    const auto made = texels(formula);
    EXPECT_EQ(made->grids, 2);
    EXPECT_EQ(made->texels.size(), 4U * made->side * made->side * made->side);
}

TEST(BrickTexels, change_with_a_parameter_and_are_the_same_again) {
    const Formula formula = understood("param a = 1 in [0, 2]\nexp(x^2 + y^2 + z^2) = 2 + a");
    scene::Document document;
    const shader::ProgramSource source = program_source(formula, document, {});
    const shader::FieldNumbers one = field_numbers(formula, source, document);
    document.parameters["a"] = 1.5;
    EXPECT_NE(one, field_numbers(formula, source, document));
    document.parameters["a"] = 1.0;
    EXPECT_EQ(one, field_numbers(formula, source, document));
}

}  // namespace
}  // namespace compile
