// SPDX-License-Identifier: MIT
// A pre-pass that cuts nothing off changes nothing of a picture, whatever region is drawn; one that
// goes by cones cuts off nothing that is seen.
#include <gtest/gtest.h>

#include <cmath>

#include "compile/compile.h"
#include "headless.h"
#include "render_answers/shot.h"

namespace render_answers {
namespace {

render::Still draw(render::Context& context, const scene::Document& document,
                   const render::View& view, bool whole_tiles) {
    constexpr shader::Outputs outputs{
        .picture = true, .geometry = true, .normal = true, .count = true};
    const auto formula = compile::compile_formula(document.formula);
    shader::Features features = compile::features(*formula, document, outputs);
    features.whole_tiles = whole_tiles;
    const shader::ProgramSource source = shader::program_source(formula->field, features);
    const shader::FieldNumbers numbers = compile::field_numbers(*formula, source, document);
    const scene::Camera camera =
        scene::camera_of(document, static_cast<double>(view.width) / view.height);
    const auto frame_of = [&](const render::View& part) {
        return render::frame(document, camera, part);
    };
    auto still = render::draw_still(context, source, numbers, frame_of, view, outputs);
    EXPECT_TRUE(still);
    return still ? std::move(*still) : render::Still();
}

TEST(Prepass, that_cuts_nothing_off_changes_nothing) {
    auto context = open_headless();
    ASSERT_TRUE(context);
    for (const char* formula :
         {"(x^2 + y^2 + z^2 + 1 - 0.09)^2 = 4(x^2 + y^2)",
          "smooth_union(menger(2), sphere(0.5), 0.1)", "box(1) \\ sphere(1.2)"})
        for (const scene::Bounds& bounds : {sphere_bounds(2), box_bounds({1, 1, 1}), no_bounds()})
            for (const render::View& view :
                 {render::whole(61, 43), render::View{97, 90, 21, 13, 50, 47}}) {
                Query query{formula, bounds};
                const scene::Document document = document_of(query);
                const render::Still without = draw(**context, document, view, false);
                const render::Still with = draw(**context, document, view, true);
                EXPECT_EQ(without.picture, with.picture) << formula;
                EXPECT_EQ(without.geometry, with.geometry) << formula;
                EXPECT_EQ(without.normal, with.normal) << formula;
            }
}

TEST(Prepass, by_cones_cuts_off_nothing_that_is_seen) {
    auto context = open_headless();
    ASSERT_TRUE(context);
    for (const char* formula : {"julia()", "menger(2) \\ sphere(0.9)", "box(1) \\ mandelbulb()",
                                "scale(menger(2), 0.5) | sphere(0.6)"}) {
        Query query{formula, sphere_bounds(2), camera({2.5, 2, 3.5})};
        const scene::Document document = document_of(query);
        const render::View view{97, 90, 21, 13, 50, 47};
        const render::Still alone = draw(**context, document, view, true);
        const render::Still cones = draw(**context, document, view, false);
        int hits = 0, different = 0;
        for (int j = 0; j < view.region_height; ++j) {
            for (int i = 0; i < view.region_width; ++i) {
                const double far = depth(alone, i, j), t = depth(cones, i, j);
                hits += std::isfinite(far);
                // Half a pixel is 0.5 % of the distance; grazing rays may end in front or behind.
                different += std::isfinite(far) != std::isfinite(t) ||
                             (std::isfinite(far) && std::abs(far - t) > 0.005 * far);
            }
        }
        EXPECT_GT(hits, 200) << formula;
        EXPECT_LE(different, hits / 50) << formula;
    }
}

}  // namespace
}  // namespace render_answers
