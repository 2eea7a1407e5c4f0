// SPDX-License-Identifier: MIT
// By what right rays are fast.
#include "compile/step_rules.h"

#include <gtest/gtest.h>

namespace compile {
namespace {

using Words = std::vector<std::string>;

std::vector<StepRule> rules(const std::string& text, const scene::Settings& settings = {},
                            scene::Bounds::Shape shape = scene::Bounds::Shape::sphere) {
    const auto formula = compile_formula(text);
    EXPECT_TRUE(formula) << text;
    if (!formula) return {};
    scene::Document document;
    document.formula = text;
    document.settings = settings;
    document.bounds.shape = shape;
    const shader::ProgramSource source = program_source(*formula, document, {});
    return step_rules(formula->field, source, field_numbers(*formula, source, document), document);
}

Words words(const std::string& text, const scene::Settings& settings = {},
            scene::Bounds::Shape shape = scene::Bounds::Shape::sphere) {
    Words list;
    for (const StepRule& rule : rules(text, settings, shape)) list.push_back(describe(rule));
    return list;
}

TEST(StepRules, say_what_is_certified) {
    EXPECT_EQ(words("sphere(1)"), Words{"certified by the distance"});
    const std::vector<StepRule> ball = rules("x^2 + y^2 + z^2 = 1");
    ASSERT_EQ(ball.size(), 1U);
    EXPECT_TRUE(ball[0].proven());
    EXPECT_EQ(ball[0].by, StepRule::By::second_derivative);
    EXPECT_NEAR(ball[0].second_derivative, 2, 0.1);
    EXPECT_NEAR(ball[0].lipschitz, 4.2, 0.4);
    EXPECT_EQ(summary(ball), "certified");
    EXPECT_EQ(words("x^4 + y^4 + z^4 = 1"),
              Words{"certified within rounding by the polynomial along the ray"});
    EXPECT_EQ(summary(rules("sphere(1) | x^4 + y^4 + z^4 = 1")), "certified within rounding");
    EXPECT_EQ(words("exp(20x) = y"), Words{"certified by bounds brick by brick"});
    scene::Settings settings;
    for (const char* tracer : {"sphere", "relaxed"}) {
        settings.tracer = tracer;
        const Words list = words("abs(x) + y^2 = 1", settings);
        EXPECT_TRUE(list[0].starts_with("certified by a Lipschitz constant (")) << list[0];
        EXPECT_TRUE(rules("x^4 + y^4 + z^4 = 1", settings)[0].proven());
    }
    settings.tracer = "interval";
    EXPECT_EQ(words("1/x = y", settings), Words{"certified by intervals along the ray"});
}

TEST(StepRules, count_bricks_where_steps_are_guesses) {
    const StepRule pole = rules("1/x = y")[0];
    EXPECT_EQ(pole.by, StepRule::By::bricks);
    EXPECT_EQ(pole.doubt, StepRule::Doubt::undefined);
    EXPECT_GT(pole.doubtful, 0U);
    EXPECT_LT(pole.doubtful, pole.bricks);
    EXPECT_EQ(describe(pole), "by bounds brick by brick: a pole or the edge of a domain in " +
                                  std::to_string(pole.doubtful) + " of " +
                                  std::to_string(pole.bricks) + " bricks");
    EXPECT_EQ(rules("floor(x*z) + 0.5 = y")[0].doubt, StepRule::Doubt::jumps);
    // At planes a step ends.
    EXPECT_TRUE(rules("floor(x) + 0.5 = y")[0].proven());
    const StepRule endless = rules("exp(x) = y", {}, scene::Bounds::Shape::none)[0];
    EXPECT_EQ(describe(endless), "by bounds brick by brick: no bounds of the region");
}

TEST(StepRules, say_why_something_is_not) {
    scene::Settings settings;
    settings.tracer = "sphere";
    EXPECT_EQ(words("1/x = y", settings),
              Words{"by the first order: a pole or the edge of a domain"});
    EXPECT_EQ(words("floor(x) + 0.5 = y", settings), Words{"by the first order: a jump"});
    EXPECT_EQ(words("exp(exp(exp(exp(x)))) = y", settings),
              Words{"by the first order: unbounded derivatives"});
    EXPECT_EQ(words("smooth_union(mandelbulb(8, 2), 1/x <= y)"),
              Words{"by parts of the region: an estimate of an iteration"});
    EXPECT_EQ(words("mandelbulb(8, 3)"),
              Words{"by the distance estimate: an estimate of an iteration"});
    EXPECT_EQ(words("x^2 = y", {}, scene::Bounds::Shape::none),
              Words{"by the first order: no bounds of the region"});
    settings.tracer = "first-order";
    EXPECT_EQ(words("x^2 = y", settings),
              Words{"by the tracer's own steps: the tracer that was chosen"});
    EXPECT_EQ(words("sphere(1)", settings), Words{"certified by the distance"});
}

TEST(StepRules, number_objects_from_left_to_right) {
    const std::vector<StepRule> list =
        rules("sphere(1) | 1/x = y | smooth_union(mandelbulb(8, 2), sphere(0.5)) | torus()");
    ASSERT_EQ(list.size(), 4U);
    const std::vector<std::size_t> first{0, 1, 2, 4}, count{1, 1, 2, 1};
    for (std::size_t i = 0; i < list.size(); ++i) {
        EXPECT_EQ(list[i].first_object, first[i]);
        EXPECT_EQ(list[i].objects, count[i]);
    }
    EXPECT_EQ(list[2].doubt, StepRule::Doubt::estimate);
    EXPECT_EQ(summary(list), "2 of 4 certified; a pole or the edge of a domain in " +
                                 std::to_string(list[1].doubtful) + " of " +
                                 std::to_string(list[1].bricks) +
                                 " bricks, an estimate of an iteration");
}

}  // namespace
}  // namespace compile
