// SPDX-License-Identifier: MIT
// The shaders by hand show what the tracers show: else they would be nothing to compare with.
#include "bench/plain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <vector>

#include "bench/generated.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "image/compare.h"
#include "render/depth_texture.h"
#include "render/still.h"

namespace bench {
namespace {

constexpr int width = 64;
constexpr int height = 48;
constexpr shader::Outputs counted{
    .picture = false, .geometry = true, .normal = true, .count = true};
class PlainTest : public testing::Test {
protected:
    void SetUp() override {
        setenv("ZEROSET_PRESETS", ZEROSET_SOURCE_DIR "/presets", 1);
        auto opened = render::open_osmesa();
        ASSERT_TRUE(opened);
        context = std::move(*opened);
    }

    render::Still draw(const Subject& subject, const shader::ProgramSource& source,
                       const shader::Outputs& outputs) {
        const auto frame_of = [&](const render::View& view) {
            return render::frame(subject.document, *subject.document.camera, view);
        };
        auto still = render::draw_still(
            *context, source, compile::field_numbers(subject.formula, source, subject.document),
            frame_of, render::whole(width, height), outputs);
        if (still) return std::move(*still);
        ADD_FAILURE() << subject.name << ": " << still.problems()[0].message;
        return {};
    }

    std::unique_ptr<render::Context> context;
};

/// The part of the pixels where only one of both hits; without those where the second gave up.
double different_part(const render::Still& a, const render::Still& b) {
    int different = 0, compared = 0;
    for (std::size_t i = 0; i < a.geometry.values.size(); i += 4) {
        const auto status = static_cast<shader::Status>(b.geometry.values[i + 2]);
        if (status == shader::Status::unresolved) continue;
        ++compared;
        different += std::isfinite(a.geometry.values[i]) != std::isfinite(b.geometry.values[i]);
    }
    return different / static_cast<double>(compared);
}

TEST_F(PlainTest, hits_where_auto_hits) {
    const auto files = find_subjects({});
    ASSERT_TRUE(files);
    std::map<std::string, std::vector<double>> different;
    std::vector<double> first_order_of_formulas;
    for (const NamedFile& file : *files) {
        if (generated_scene(file.name)) continue;  // takes long to link
        auto subject = read_subject(file.path, file.name, double(width) / height);
        ASSERT_TRUE(subject);
        // So that both end nearly at the surface, each by its own rule.
        subject->document.settings.epsilon = 0.05;
        const auto names = plain_names(*subject);
        if (names.empty()) continue;
        const shader::ProgramSource source =
            compile::program_source(subject->formula, subject->document, counted);
        if (!source.families.empty()) continue;  // as text they take long to link
        const render::Still expected = draw(*subject, source, counted);
        for (const std::string& name : names) {
            const auto actual = draw(*subject, plain_source(*subject, name, counted), counted);
            different[name].push_back(different_part(expected, actual));
            const double most = name == plain_name ? 0.02 : name == plain_sphere_name ? 0.01 : 0.4;
            EXPECT_LE(different[name].back(), most) << file.name << ", " << name;
            const field::Field& field = subject->formula.field;
            if (name == plain_first_order_name &&
                std::holds_alternative<field::Formula>(field[field.root])) {
                first_order_of_formulas.push_back(different[name].back());
            }
        }
    }
    EXPECT_EQ(different[std::string(plain_name)].size(), 7U);
    EXPECT_GE(different[std::string(plain_sphere_name)].size(), 25U);
    // Unsafe as it is, it shows most formulas as they are.
    EXPECT_LE(quantile(first_order_of_formulas, 0.5), 0.01);
}

TEST_F(PlainTest, are_meant_for_formulas_and_three_fractals) {
    const auto names = [](const std::string& preset) {
        const auto files = find_subjects({preset});
        const auto subject = read_subject((*files)[0].path, (*files)[0].name, 1);
        return plain_names(*subject);
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(names("mandelbulb"), Names{"plain"});
    EXPECT_EQ(names("heart"), (Names{"plain sphere", "plain first-order"}));
    EXPECT_EQ(names("gearbox"), Names{});
    for (const auto& [text, has_one] : {std::pair{"sphere(1) \\ box(0.5) | torus()", true},
                                        {"x = 0 & sphere(1)", false},
                                        {"sphere(1) | julia()", false}}) {
        Subject joined;
        joined.document.formula = text;
        joined.formula = std::move(*compile::compile_formula(text));
        EXPECT_EQ(plain_names(joined),
                  has_one ? (Names{"plain sphere", "plain first-order"}) : Names{})
            << text;
    }
    Subject steep;
    steep.document.formula = "cbrt(x) = y";
    steep.formula = std::move(*compile::compile_formula(steep.document.formula));
    EXPECT_EQ(plain_names(steep), Names{"plain first-order"}) << "its slope has no bound";
}

TEST_F(PlainTest, counts_evaluations_and_draws_a_picture_of_the_same_light) {
    const auto files = find_subjects({"surfaces/sphere"});
    const auto subject = read_subject((*files)[0].path, "surfaces/sphere", double(width) / height);
    ASSERT_TRUE(subject);
    const auto plain = plain_source(*subject, std::string(plain_sphere_name), counted);
    const render::Still still = draw(*subject, plain, counted);
    double evaluations = 0;
    for (std::size_t i = 3; i < still.normal.values.size(); i += 4) {
        evaluations += still.normal.values[i];
    }
    EXPECT_GT(evaluations / (width * height), 3);
    EXPECT_LT(evaluations / (width * height), 100);
    const shader::Outputs picture{};
    const auto expected = draw(
        *subject, compile::program_source(subject->formula, subject->document, picture), picture);
    const auto actual =
        draw(*subject, plain_source(*subject, std::string(plain_sphere_name), picture), picture);
    const auto difference = image::compare(expected.picture, actual.picture, 8);
    EXPECT_LE(difference.changed, width * height / 50U);
}

TEST_F(PlainTest, the_limit_shows_what_auto_shows) {
    for (const char* name :
         {"surfaces/heart", "periodic/gyroid", "fractals/menger_sponge", "fractals/julia_default",
          "solids/drilled_die", "solids/sliced_torus"}) {
        const auto files = find_subjects({name});
        auto subject = read_subject((*files)[0].path, name, double(width) / height);
        ASSERT_TRUE(subject);
        subject->document.settings.shadows = false;
        const shader::Outputs all{.picture = true, .geometry = true};
        const auto expected =
            draw(*subject, compile::program_source(subject->formula, subject->document, all), all);
        image::Grey depth(width, height);
        for (std::size_t i = 0; i < depth.values.size(); ++i) {
            depth.values[i] = expected.geometry.values[4 * i];
        }
        const auto told = render::DepthTexture::create(context->gl(), depth);
        ASSERT_TRUE(told);
        told->bind();
        shader::Features features = compile::features(subject->formula, subject->document, all);
        features.told_depth = true;
        const auto actual =
            draw(*subject, shader::program_source(subject->formula.field, features), all);
        const auto difference = image::compare(expected.picture, actual.picture, 8);
        EXPECT_LE(difference.changed, width * height / 100U) << name;
    }
}

}  // namespace
}  // namespace bench
