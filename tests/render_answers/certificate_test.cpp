// SPDX-License-Identifier: MIT
// What pictures prove of themselves, against the reference.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "compile/compile.h"
#include "oracle/trace.h"
#include "render_answers/shot.h"

namespace render_answers {
namespace {

using shader::Certificate;

constexpr shader::Outputs certified{
    .picture = true, .geometry = true, .normal = true, .certificate = true};

Certificate certificate(const render::Still& still, int i, int j) {
    return shader::certificate_in(still.normal.at(i, j)[3]);
}

int count(const render::Still& still, Certificate wanted) {
    int number = 0;
    for (std::size_t i = 3; i < still.normal.values.size(); i += 4) {
        number += shader::certificate_in(still.normal.values[i]) == wanted;
    }
    return number;
}

render::Still shot(const Query& query) {
    return render(document_of(query), render::whole(query.width, query.height), certified);
}

TEST(Certificate, what_is_proven_is_right) {
    int proven = 0, pixels = 0;
    for (const char* formula :
         {"x^2 + y^2 + z^2 = 1", "(x^2 + 9/4 y^2 + z^2 - 1)^3 = x^2 z^3 + 9/80 y^2 z^3",
          "sin(4x)cos(4y) + sin(4y)cos(4z) + sin(4z)cos(4x) = 0",
          "box(1, 0.7, 0.8) \\ sphere(0.9) | torus(1.2, 0.2)",
          "smooth_union(sphere(0.7), translate(box(0.4), (0.8, 0.1, 0)), 0.3)",
          "repeat(sphere(0.3), (1, 1, 1)) & sphere(1.5)", "x^4 + y^4 + z^4 - 1.2 <= 0",
          "z^2 = 0.3x^3 + 0.2y", "1/(x + 1.7) + y = z", "floor(2x) = 2z + 0.5"}) {
        Query query{.formula = formula, .width = 48, .height = 36};
        query.camera = camera({2, 1.6, 3.2});
        const scene::Document document = document_of(query);
        const render::Still still = shot(query);
        const auto reference =
            oracle::trace(*compile::compile_formula(formula), document,
                          {.width = 48, .height = 36, .region = {}, .threads = 1, .progress = {}});
        ASSERT_TRUE(reference);
        for (int j = 0; j < query.height; ++j) {
            for (int i = 0; i < query.width; ++i) {
                const oracle::Pixel& right = reference->at(i, j);
                if (right.verdict == oracle::Verdict::undecided || right.fragile) continue;
                const Certificate got = certificate(still, i, j);
                const bool hit = right.verdict == oracle::Verdict::hit;
                ++pixels;
                EXPECT_FALSE(hit && got == Certificate::proven_miss) << formula;
                if (got == Certificate::proven_hit) {
                    EXPECT_TRUE(hit) << formula;
                    EXPECT_NEAR(depth(still, i, j), right.depth(),
                                0.5 * reference->pixel_width * right.depth())
                        << formula;
                }
                proven += got == Certificate::proven_hit || got == Certificate::proven_miss;
            }
        }
    }
    // Not the last two scenes, which have a pole and jumps, nor hits within rounding.
    EXPECT_GT(proven, 0.5 * pixels);
}

TEST(Certificate, agrees_with_status_and_colour) {
    const Query query{.formula = "x^2 + y^2 + z^2 = 1", .camera = camera({2, 1.6, 3.2})};
    const render::Still still = shot(query);
    Query coloured = query;
    coloured.settings.show_certificate = true;
    const render::Still colours = shot(coloured);
    // Those of oracle::certificate_picture and one more.
    constexpr std::array<std::array<int, 3>, shader::certificate_count> expected{{{215, 215, 215},
                                                                                  {25, 35, 80},
                                                                                  {255, 210, 0},
                                                                                  {80, 80, 20},
                                                                                  {235, 130, 40},
                                                                                  {75, 45, 30},
                                                                                  {255, 0, 255}}};
    for (int j = 0; j < query.height; ++j) {
        for (int i = 0; i < query.width; ++i) {
            const Certificate what = certificate(still, i, j);
            const bool hit = what == Certificate::proven_hit ||
                             what == Certificate::hit_within_rounding ||
                             what == Certificate::heuristic_hit;
            EXPECT_EQ(hit, status(still, i, j) == shader::Status::hit);
            for (int k = 0; k < 3; ++k) {
                EXPECT_EQ(colours.picture.at(i, j)[k],
                          expected[static_cast<std::size_t>(what)][static_cast<std::size_t>(k)]);
            }
        }
    }
    EXPECT_EQ(count(still, Certificate::heuristic_hit), 0);
    EXPECT_EQ(count(still, Certificate::heuristic_miss), 0);
    EXPECT_GT(count(still, Certificate::proven_hit), 500);
}

TEST(Certificate, proves_nothing_by_steps_that_are_too_long) {
    Query query{.formula = "x^2 + y^2 + z^2 = 1", .camera = camera({2, 1.6, 3.2})};
    query.settings.lipschitz = 0.9;
    EXPECT_EQ(count(shot(query), Certificate::proven_hit), 0);
    query.settings.lipschitz = 2;
    EXPECT_EQ(count(shot(query), Certificate::heuristic_hit), 0);
    query.settings.lipschitz = 1;
    for (const char* tracer : {"march", "first-order", "second-order"}) {
        query.settings.tracer = tracer;
        EXPECT_EQ(count(shot(query), Certificate::proven_hit), 0) << tracer;
    }
    for (const char* tracer : {"sphere", "relaxed", "interval"}) {
        query.settings.tracer = tracer;
        EXPECT_GT(count(shot(query), Certificate::proven_hit), 500) << tracer;
    }
    query.settings.tracer = "auto";
    query.settings.steps = 2;
    EXPECT_GT(count(shot(query), Certificate::unresolved), 0);
    query.settings.steps = 1024;
    // The rounding of a polynomial's coefficients is estimated.
    query.formula = "x^4 + y^4 + z^4 = 1";
    const render::Still quartic = shot(query);
    EXPECT_EQ(count(quartic, Certificate::proven_hit), 0);
    EXPECT_GT(count(quartic, Certificate::hit_within_rounding), 500);
    EXPECT_GT(count(quartic, Certificate::miss_within_rounding), 0);
    EXPECT_EQ(count(quartic, Certificate::heuristic_hit), 0);
    // Bricks in which f jumps, and bricks in which it does not.
    query.formula = "z + 0.4 + 0.2 floor(10 * (x - 0.8)^2) = 0";
    const render::Still bricks = shot(query);
    EXPECT_GT(count(bricks, Certificate::proven_hit), 50);
    EXPECT_GT(count(bricks, Certificate::heuristic_hit), 50);
    query.formula = "mandelbulb(8, 3)";
    const render::Still fractal = shot(query);
    EXPECT_EQ(count(fractal, Certificate::proven_hit), 0);
    EXPECT_GT(count(fractal, Certificate::heuristic_hit), 0);
}

}  // namespace
}  // namespace render_answers
