// SPDX-License-Identifier: MIT
// A pre-pass that cuts nothing off changes nothing of a picture, whatever region is drawn.
#include <gtest/gtest.h>

#include "compile/compile.h"
#include "render_answers/shot.h"

namespace render_answers {
namespace {

render::Still draw(render::Context& context, const scene::Document& document,
                   const render::View& view, bool whole_tiles) {
    constexpr shader::Outputs outputs{
        .picture = true, .geometry = true, .normal = true, .count = true};
    const auto formula = compile::compile_formula(document.formula);
    shader::Features features = compile::features(document, outputs);
    features.whole_tiles = whole_tiles;
    const shader::ProgramSource source = shader::program_source(formula->field, features);
    EXPECT_EQ(source.prepass.empty(), !whole_tiles);
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
    auto context = render::open_osmesa();
    ASSERT_TRUE(context);
    for (const char* formula :
         {"(x^2 + y^2 + z^2 + 1 - 0.09)^2 = 4(x^2 + y^2)", "mandelbulb()", "box(1) \\ sphere(1.2)"})
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

}  // namespace
}  // namespace render_answers
