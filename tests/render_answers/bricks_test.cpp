// SPDX-License-Identifier: MIT
// Bounds brick by brick change how far steps go, and nothing of what is seen.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/counted_budget.h"
#include "compile/compile.h"
#include "headless.h"
#include "render_answers/shot.h"

namespace render_answers {
namespace {

constexpr shader::Outputs counted{
    .picture = false, .geometry = true, .normal = true, .count = true};

render::Still draw(const Query& query, bool by_bricks, const analysis::Budget* budget = nullptr) {
    const scene::Document document = document_of(query);
    const auto formula = compile::compile_formula(document.formula);
    shader::Features features = compile::features(*formula, document, counted);
    EXPECT_FALSE(features.bricks.empty()) << query.formula;
    if (!by_bricks) features.bricks.clear();
    const shader::ProgramSource source = shader::program_source(formula->field, features);
    const shader::FieldNumbers numbers = compile::field_numbers(*formula, source, document, budget);
    EXPECT_EQ(numbers.bricks != nullptr, by_bricks);
    const render::View view = render::whole(query.width, query.height);
    const scene::Camera camera =
        scene::camera_of(document, static_cast<double>(view.width) / view.height);
    const auto frame_of = [&](const render::View& part) {
        return render::frame(document, camera, part);
    };
    auto context = open_headless();
    auto still = render::draw_still(**context, source, numbers, frame_of, view, counted);
    EXPECT_TRUE(still);
    return still ? std::move(*still) : render::Still();
}

double evaluations(const render::Still& still) {
    double sum = 0;
    for (std::size_t i = 3; i < still.normal.values.size(); i += 4) sum += still.normal.values[i];
    return sum;
}

/// Pixels that are a hit in one picture only, or at another depth, but for those whose ray grazes a
/// surface or nearly does.
int different(const render::Still& a, const render::Still& b) {
    int number = 0;
    for (int y = 0; y < a.geometry.height; ++y) {
        for (int x = 0; x < a.geometry.width; ++x) {
            const double s = depth(a, x, y), t = depth(b, x, y);
            if (std::isinf(s) && std::isinf(t)) continue;
            const bool same = std::abs(s - t) <= 1e-4 * s;
            number += !same;
        }
    }
    return number;
}

TEST(Bricks, change_no_picture_that_is_certified_without_them_but_at_silhouettes) {
    // Steep, with kinks, a solid, two formulas, and cut by a box.
    for (const char* formula :
         {"exp(x^2 + y^2 + z^2) = 3 + x*y", "r - 0.12 sin(9x) sin(9y) sin(9z) = 1",
          "sin(z) = sinh(x)*sinh(y)", "y <= exp(-x^2 - z^2) - 0.5",
          "(x*exp(y) + z^2 <= 0.5) \\ (y >= exp(x) - 0.5)"}) {
        for (const scene::Bounds& bounds :
             {sphere_bounds(1.5), box_bounds({1.2, 0.9, 1.4}, {0.1, 0.05, 0})}) {
            Query query{formula, bounds, camera({2.1, 1.5, 3.2}), {}, 60, 45};
            query.settings.epsilon = 0.01;
            const render::Still without = draw(query, false), with = draw(query, true);
            // Rays that pass within a hundredth of a pixel may count as hits.
            EXPECT_LE(different(without, with), 4) << formula;
            EXPECT_EQ(count(with, shader::Status::unresolved), 0) << formula;
        }
    }
}

TEST(Bricks, that_are_coarse_for_lack_of_time_show_the_same) {
    Query query{"exp(x^2 + y^2 + z^2) = 3 + x*y", sphere_bounds(1.5), camera({2.1, 1.5, 3.2})};
    query.settings.epsilon = 0.01;
    const render::Still fine = draw(query, true);
    double most = 0;
    for (const int questions : {0, 3, 30, 300}) {
        const analysis::Budget budget = analysis::over_after(questions);
        const render::Still coarse = draw(query, true, &budget);
        EXPECT_TRUE(budget.was_over());
        EXPECT_LE(different(fine, coarse), 4) << questions;
        EXPECT_EQ(count(coarse, shader::Status::unresolved), 0) << questions;
        most = std::max(most, evaluations(coarse));
    }
    EXPECT_GT(most, 1.2 * evaluations(fine));
}

TEST(Bricks, save_evaluations_where_the_bound_of_the_region_is_poor) {
    const Query steep{"exp(x^2 + y^2 + z^2) = 3 + x*y", sphere_bounds(2), camera({2.1, 1.5, 4.2})};
    EXPECT_LT(evaluations(draw(steep, true)), 0.5 * evaluations(draw(steep, false)));
}

/// A pole costs the certificate of its own bricks; the sheet beside it is seen as without bricks.
TEST(Bricks, leave_poles_and_edges_as_they_are) {
    for (const char* formula : {"y = 0.1/x", "y = sqrt(x) - z^2", "y = log(x + 1) + 0.2z"}) {
        const Query query{formula, sphere_bounds(1.5), camera({2.1, 1.5, 3.2}), {}, 60, 45};
        EXPECT_LE(different(draw(query, false), draw(query, true)), 60 * 45 / 100) << formula;
    }
}

}  // namespace
}  // namespace render_answers
