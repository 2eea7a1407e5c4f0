// SPDX-License-Identifier: MIT
// What is traced, drawn and measured when; with a tracer and a driver that only pretend.
#include "studio/accuracy_check.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "fake_trace.h"

namespace {

using studio::Accuracy;
using studio::AccuracyCheck;
using studio::Judged;
using studio::PresentView;
using studio::TrialAnswer;
using studio::TrialRequest;
using Phase = Accuracy::Phase;
using Wish = Accuracy::Wish;

/// A window that can be looked at, and a driver that misses more the smaller the Lipschitz scale.
struct Studio {
    FakeTrace fake;
    Accuracy accuracy;
    AccuracyCheck check{accuracy, fake.function(), [] {}};
    PresentView view;
    double now = 0;
    int trials = 0;

    Studio() {
        view.document.formula = "x = 0";
        view.camera = {.eye = {0, 0, 5}};
        view.width = 40;
        view.height = 16;
        view.watched = true;
    }

    void look(double seconds = 0.01) {
        now += seconds;
        check.look(view, now);
    }

    static TrialAnswer draw(const TrialRequest& request) {
        TrialAnswer answer{.id = request.id, .seconds = 0.1 * request.document.settings.lipschitz};
        if (!request.judged) return answer;
        const int width = request.reference->width;
        oracle::Shot shot;
        shot.depth = image::Grey(width, request.reference->height);
        std::ranges::fill(shot.depth.values, INFINITY);
        const double scale = std::min(1.0, request.document.settings.lipschitz);
        for (std::size_t i = 0; i < shot.depth.values.size(); ++i) {
            const int x = static_cast<int>(i) % width;
            if (2 * x < scale * width) shot.depth.values[i] = 1;
        }
        auto metrics = oracle::compare(*request.reference, shot);
        answer.judged = std::make_shared<const Judged>(Judged{std::move(*metrics), {}});
        return answer;
    }

    /// Looks and draws until there is nothing more to do.
    void settle() {
        ASSERT_TRUE(comes_true([&] {
            look(0);
            if (const auto trial = check.next_trial()) {
                ++trials;
                check.take(draw(*trial));
                look(0);
            }
            return accuracy.phase == Phase::idle;
        }));
    }

    void check_view() {
        accuracy.wish = Wish::check;
        look();
        settle();
    }

    void wish(Wish wanted) {
        accuracy.wish = wanted;
        look();
    }
};

TEST(AccuracyCheck, does_nothing_until_it_is_asked) {
    Studio studio;
    studio.look();
    studio.look(1000);
    EXPECT_EQ(studio.accuracy.phase, Phase::idle);
    EXPECT_EQ(studio.fake.begun, 0);
    EXPECT_FALSE(studio.check.next_trial());
    EXPECT_EQ(studio.check.wait(studio.now), INFINITY);
}

TEST(AccuracyCheck, traces_then_judges_the_present_setting) {
    Studio studio;
    studio.view.document.settings.lipschitz = 0.5;
    studio.fake.holds = true;
    studio.wish(Wish::check);
    EXPECT_EQ(studio.accuracy.phase, Phase::tracing);
    EXPECT_FALSE(studio.accuracy.judged());
    studio.fake.holds = false;
    studio.settle();
    ASSERT_TRUE(studio.accuracy.of_this_view);
    ASSERT_TRUE(studio.accuracy.judged());
    // A quarter of the sides: 10 x 4 pixels, of which the tracer finds 3 of 5 columns.
    const oracle::Metrics& metrics = studio.accuracy.judged()->metrics;
    EXPECT_EQ(metrics.compared, 40u);
    EXPECT_EQ(metrics.missed, 8u);
    EXPECT_EQ(studio.accuracy.measured.size(), 1u);
    EXPECT_DOUBLE_EQ(*studio.accuracy.measured[0].frame_seconds(), 0.05);
}

TEST(AccuracyCheck, keeps_the_reference_while_only_the_tracing_changes) {
    Studio studio;
    studio.check_view();
    EXPECT_EQ(studio.accuracy.judged()->metrics.missed, 0u);
    studio.view.document.settings.lipschitz = 0.5;
    studio.look();
    EXPECT_EQ(studio.accuracy.phase, Phase::judging);
    EXPECT_FALSE(studio.accuracy.judged());
    EXPECT_EQ(studio.accuracy.last_judged->metrics.missed, 0u);
    studio.settle();
    EXPECT_EQ(studio.accuracy.judged()->metrics.missed, 8u);
    EXPECT_EQ(studio.accuracy.last_judged->metrics.missed, 8u);
    EXPECT_EQ(studio.fake.begun, 1);
    // What has been judged already is known.
    const int trials = studio.trials;
    studio.view.document.settings.lipschitz = 1;
    studio.look();
    ASSERT_TRUE(studio.accuracy.judged());
    EXPECT_EQ(studio.accuracy.judged()->metrics.missed, 0u);
    EXPECT_EQ(studio.accuracy.phase, Phase::idle);
    EXPECT_EQ(studio.trials, trials);
}

TEST(AccuracyCheck, judges_the_newest_setting_where_one_is_still_being_drawn) {
    Studio studio;
    studio.check_view();
    studio.view.document.settings.lipschitz = 0.5;
    studio.look();
    const auto old = studio.check.next_trial();
    ASSERT_TRUE(old);
    EXPECT_FALSE(studio.check.next_trial()) << "one at a time";
    studio.view.document.settings.lipschitz = 0.25;
    studio.look();
    const auto trial = studio.check.next_trial();
    ASSERT_TRUE(trial);
    EXPECT_EQ(trial->document.settings.lipschitz, 0.25);
    // The answer to the old one is not taken for one to the new.
    studio.check.take(Studio::draw(*old));
    studio.look();
    EXPECT_FALSE(studio.accuracy.judged());
    studio.check.take(Studio::draw(*trial));
    studio.look();
    EXPECT_EQ(studio.accuracy.judged()->metrics.missed, 12u);
}

TEST(AccuracyCheck, draws_the_view_of_the_reference_as_it_is_lit) {
    Studio studio;
    studio.view.document.settings.grid = true;
    studio.view.document.settings.show_steps = true;
    studio.wish(Wish::check);
    ASSERT_TRUE(comes_true([&] {
        studio.look();
        return studio.accuracy.reference != nullptr;
    }));
    const auto trial = studio.check.next_trial();
    ASSERT_TRUE(trial && trial->formula && trial->reference);
    EXPECT_EQ(trial->document.camera, studio.view.camera);
    EXPECT_TRUE(trial->document.settings.grid);
    EXPECT_FALSE(trial->document.settings.show_steps);
    EXPECT_TRUE(trial->judged);
}

TEST(AccuracyCheck, gives_tracing_up_when_the_view_changes) {
    Studio studio;
    studio.fake.holds = true;
    studio.wish(Wish::check);
    ASSERT_TRUE(comes_true([&] { return studio.fake.begun == 1; }));
    studio.view.camera.eye.x = 1;
    studio.look();
    EXPECT_EQ(studio.accuracy.phase, Phase::idle);
    EXPECT_TRUE(comes_true([&] { return studio.fake.given_up == 1; }));
    EXPECT_FALSE(studio.accuracy.reference);
    EXPECT_EQ(studio.accuracy.problem, "given up: the view has changed");
}

TEST(AccuracyCheck, knows_an_earlier_view_and_knows_it_again) {
    Studio studio;
    studio.check_view();
    studio.view.camera.eye.x = 1;
    studio.look();
    EXPECT_FALSE(studio.accuracy.of_this_view);
    EXPECT_FALSE(studio.accuracy.judged());
    EXPECT_FALSE(studio.check.next_trial());
    studio.view.camera.eye.x = 0;
    studio.look();
    EXPECT_TRUE(studio.accuracy.judged());
    EXPECT_EQ(studio.fake.begun, 1);
}

TEST(AccuracyCheck, keeps_checking_when_the_view_has_come_to_rest) {
    Studio studio;
    studio.accuracy.keep_checking = true;
    studio.look();
    EXPECT_EQ(studio.fake.begun, 0);
    EXPECT_NEAR(studio.check.wait(studio.now), AccuracyCheck::rest_seconds, 1e-9);
    studio.look(0.4);
    studio.view.camera.eye.x = 1;
    studio.look(0.4);
    EXPECT_EQ(studio.accuracy.phase, Phase::idle) << "it has moved only now";
    studio.look(AccuracyCheck::rest_seconds);
    EXPECT_EQ(studio.accuracy.phase, Phase::tracing);
    studio.settle();
    EXPECT_TRUE(studio.accuracy.of_this_view);
    EXPECT_EQ(studio.check.wait(studio.now), INFINITY);
    studio.look(10);
    EXPECT_EQ(studio.fake.begun, 1) << "nothing has changed";
    studio.view.watched = false;
    studio.view.camera.eye.x = 2;
    studio.look(10);
    studio.look(10);
    EXPECT_EQ(studio.fake.begun, 1) << "nobody looks";
}

TEST(AccuracyCheck, does_not_try_again_what_has_failed) {
    Studio studio;
    studio.fake.fails = true;
    studio.accuracy.keep_checking = true;
    studio.look();
    studio.look(1);
    studio.settle();
    EXPECT_EQ(studio.accuracy.problem, "the picture is too steep");
    studio.look(1);
    studio.look(1);
    EXPECT_EQ(studio.fake.begun, 1);
    studio.fake.fails = false;
    studio.check_view();
    EXPECT_EQ(studio.accuracy.problem, "");
    EXPECT_TRUE(studio.accuracy.judged());
}

TEST(AccuracyCheck, says_that_a_broken_formula_must_be_corrected) {
    Studio studio;
    studio.view.document.formula = "x = ";
    studio.check_view();
    EXPECT_EQ(studio.accuracy.problem, "the formula has errors; correct it, and check again");
}

TEST(AccuracyCheck, does_not_check_while_the_time_runs) {
    Studio studio;
    studio.view.playing = true;
    studio.wish(Wish::check);
    EXPECT_EQ(studio.accuracy.phase, Phase::idle);
}

TEST(AccuracyCheck, measures_all_settings_in_turns) {
    Studio studio;
    studio.check_view();
    studio.wish(Wish::measure);
    EXPECT_EQ(studio.accuracy.phase, Phase::measuring);
    studio.settle();
    const auto& measured = studio.accuracy.measured;
    EXPECT_EQ(measured.size(), studio::neighbours(studio::tracing_of({})).size());
    for (const studio::MeasuredSetting& setting : measured) {
        ASSERT_TRUE(setting.judged && setting.frame_seconds());
        EXPECT_DOUBLE_EQ(*setting.frame_seconds(), 0.1 * setting.tracing.lipschitz);
        const double scale = std::min(1.0, setting.tracing.lipschitz);
        const auto found = static_cast<std::size_t>(std::ceil(5 * scale));
        EXPECT_EQ(setting.judged->metrics.missed, 4 * (5 - found));
        EXPECT_EQ(setting.seconds.size(), measured[0].seconds.size());
    }
    EXPECT_EQ(studio.fake.begun, 1);
}

TEST(AccuracyCheck, measures_nothing_without_a_reference_of_the_view) {
    Studio studio;
    studio.wish(Wish::measure);
    EXPECT_EQ(studio.accuracy.phase, Phase::idle);
    studio.check_view();
    studio.wish(Wish::measure);
    studio.view.document.time = 1;
    studio.look();
    EXPECT_EQ(studio.accuracy.phase, Phase::idle) << "the view has changed";
}

TEST(AccuracyCheck, stops_when_the_user_wants_it_to) {
    Studio studio;
    studio.fake.holds = true;
    studio.accuracy.keep_checking = true;
    studio.wish(Wish::check);
    studio.wish(Wish::cancel);
    EXPECT_EQ(studio.accuracy.phase, Phase::idle);
    EXPECT_FALSE(studio.accuracy.keep_checking);
    studio.fake.holds = false;
    studio.check_view();
    studio.wish(Wish::measure);
    studio.check.take(Studio::draw(*studio.check.next_trial()));
    studio.wish(Wish::cancel);
    studio.look(1);
    EXPECT_EQ(studio.accuracy.phase, Phase::idle);
    EXPECT_FALSE(studio.check.next_trial());
}

TEST(AccuracyCheck, asks_again_for_what_was_given_up_and_leaves_out_what_fails) {
    Studio studio;
    studio.check_view();
    studio.wish(Wish::measure);
    auto trial = studio.check.next_trial();
    studio.check.take({.id = trial->id, .given_up = true});
    auto again = studio.check.next_trial();
    ASSERT_TRUE(again);
    EXPECT_EQ(again->document.settings, trial->document.settings);
    studio.check.take({.id = again->id, .problems = {base::error("the driver says no")}});
    studio.settle();
    EXPECT_EQ(studio.accuracy.problem, "auto, Lipschitz scale 1: the driver says no");
    EXPECT_TRUE(studio.accuracy.measured[0].failed);
    EXPECT_FALSE(studio.accuracy.measured[0].frame_seconds());
    EXPECT_TRUE(studio.accuracy.measured[1].frame_seconds());
}

TEST(AccuracyCheck, forgets_times_but_not_judgements_when_the_light_changes) {
    Studio studio;
    studio.check_view();
    studio.wish(Wish::measure);
    studio.settle();
    studio.view.document.settings.exposure = 2;
    studio.look();
    EXPECT_TRUE(studio.accuracy.measured[1].frame_seconds());
    studio.view.document.settings.shadows = false;
    studio.look();
    EXPECT_TRUE(studio.accuracy.measured[1].judged);
    EXPECT_FALSE(studio.accuracy.measured[1].frame_seconds());
}

TEST(AccuracyCheck, remembers_only_so_many_settings) {
    Studio studio;
    studio.check_view();
    for (int i = 0; i < 100; ++i) {
        studio.view.document.settings.lipschitz = 1 + 0.01 * i;
        studio.settle();
        ASSERT_TRUE(studio.accuracy.judged());
    }
    EXPECT_LE(studio.accuracy.measured.size(), 48u);
}

}  // namespace
