// SPDX-License-Identifier: MIT
// Frames that are drawn to be judged, on a context without a window.
#include "studio/trial_canvas.h"

#include <gtest/gtest.h>

#include "oracle/trace.h"
#include "render/context.h"
#include "studio/reference_key.h"

namespace {

using studio::TrialAnswer;
using studio::TrialCanvas;
using studio::TrialRequest;

bool never() { return false; }

/// A ball in front of the camera, with its reference.
struct TrialCanvasTest : testing::Test {
    std::unique_ptr<render::Context> context;
    TrialRequest trial;

    void SetUp() override {
        auto opened = render::open_osmesa();
        ASSERT_TRUE(opened);
        context = std::move(*opened);
        trial.id = 7;
        trial.judged = true;
        trial.document.formula = "x^2 + y^2 + z^2 = 1";
        trial.document.camera = scene::Camera{.eye = {0, 0, 4}, .target = {0, 0, 0}};
        auto formula = compile::compile_formula(trial.document.formula);
        ASSERT_TRUE(formula);
        trial.formula = std::make_shared<const compile::Formula>(std::move(*formula));
        const auto key = studio::reference_key(trial.document, *trial.document.camera, 48, 40, 1);
        oracle::Query query;
        query.width = key.width;
        query.height = key.height;
        auto reference = oracle::trace(*trial.formula, key.scene, query);
        ASSERT_TRUE(reference);
        trial.reference = std::make_shared<const oracle::Reference>(std::move(*reference));
    }
};

TEST_F(TrialCanvasTest, finds_what_the_reference_finds) {
    TrialCanvas canvas(context->gl());
    const TrialAnswer answer = canvas.draw(trial, never);
    EXPECT_EQ(answer.id, 7u);
    EXPECT_FALSE(answer.given_up);
    EXPECT_GT(answer.seconds, 0);
    ASSERT_TRUE(answer.judged);
    const oracle::Metrics& metrics = answer.judged->metrics;
    EXPECT_EQ(metrics.compared + metrics.fragile + metrics.undecided, 48u * 40u);
    EXPECT_LE(metrics.wrong(), 8u) << "but for some along the outline";
    EXPECT_LT(metrics.depth_error.largest, 1e-5);
}

TEST_F(TrialCanvasTest, sees_that_a_tracer_gives_up) {
    TrialCanvas canvas(context->gl());
    trial.document.settings.tracer = "sphere";
    trial.document.settings.lipschitz = 8;
    trial.document.settings.steps = 2;
    const TrialAnswer answer = canvas.draw(trial, never);
    ASSERT_TRUE(answer.judged);
    EXPECT_GT(answer.judged->metrics.gave_up, 100u);
    EXPECT_GT(answer.judged->metrics.wrong(), 100u);
    EXPECT_FALSE(answer.judged->areas.empty());
}

TEST_F(TrialCanvasTest, only_times_where_it_is_not_asked_to_judge) {
    TrialCanvas canvas(context->gl());
    trial.judged = false;
    const TrialAnswer answer = canvas.draw(trial, never);
    EXPECT_TRUE(answer.problems.empty());
    EXPECT_FALSE(answer.judged);
    EXPECT_GT(answer.seconds, 0);
}

TEST_F(TrialCanvasTest, gives_up_between_bands_of_rows) {
    TrialCanvas canvas(context->gl());
    int looks = 0;
    // Slow enough that 40 rows are drawn in several bands.
    trial.expected_seconds = 1;
    const TrialAnswer answer = canvas.draw(trial, [&] { return ++looks == 3; });
    EXPECT_TRUE(answer.given_up);
    EXPECT_FALSE(answer.judged);
    EXPECT_EQ(looks, 3);
    EXPECT_TRUE(canvas.draw(trial, never).judged);
}

}  // namespace
