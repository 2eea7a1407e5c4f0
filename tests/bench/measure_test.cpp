// SPDX-License-Identifier: MIT
// Small runs: what is counted is right, whatever the times are.
#include "bench/measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace bench {
namespace {

/// A ball that covers a known part of the picture.
Subject ball() {
    Subject subject;
    subject.name = "ball";
    subject.document.formula = "x^2 + y^2 + z^2 = 1";
    subject.document.camera = scene::Camera{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 20};
    auto formula = compile::compile_formula(subject.document.formula);
    if (formula) subject.formula = std::move(*formula);
    return subject;
}

class MeasureTest : public testing::Test {
protected:
    void SetUp() override {
        auto opened = render::open_osmesa();
        ASSERT_TRUE(opened);
        context = std::move(*opened);
    }
    PresetReport run(const Options& options) {
        auto report = measure(*context, ball(), options, nullptr);
        if (report) return std::move(report->report);
        ADD_FAILURE() << report.problems()[0].message;
        return {};
    }

    std::unique_ptr<render::Context> context;
};

Options small() {
    Options options;
    options.tracers = {"auto", "sphere"};
    options.sweeps = {{"steps", {1, 1024}}};
    options.width = 40;
    options.height = 30;
    options.reference_width = 40;
    options.reference_height = 30;
    options.rounds = 3;
    return options;
}

TEST_F(MeasureTest, has_an_entry_for_each_tracer_and_setting_with_a_time_for_each_round) {
    const PresetReport report = run(small());
    ASSERT_EQ(report.preset, "ball");
    EXPECT_EQ(report.yardstick_seconds.size(), 3U);
    for (const char* tracer : {"auto", "sphere"}) {
        for (const Move& move : {Move{}, Move{"steps", 1}}) {
            const Entry* entry = find(report, tracer, move);
            ASSERT_NE(entry, nullptr) << tracer << ' ' << text(move);
            ASSERT_EQ(entry->seconds.size(), 3U);
            for (const double seconds : entry->seconds) EXPECT_GT(seconds, 0);
        }
        EXPECT_GT(find(report, tracer)->link_seconds, 0);
        EXPECT_GT(find(report, tracer)->first_frame_seconds, 0);
    }
    EXPECT_EQ(find(report, "auto", {"steps", 1024}), nullptr) << "the preset's own setting";
}

TEST_F(MeasureTest, counts_pixels_and_evaluations) {
    const PresetReport report = run(small());
    const Entry* entry = find(report, "auto");
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(entry->hit + entry->miss + entry->unresolved, 1200U);
    // The cone to the ball's outline: its slope is 1 / sqrt(99), the picture's half height tan 10.
    const double radius = 15 / std::sqrt(99.0) / std::tan(10 * std::numbers::pi / 180);
    EXPECT_NEAR(static_cast<double>(entry->hit), std::numbers::pi * radius * radius, 12);
    EXPECT_GT(*entry->evaluations, 0.5);
    EXPECT_LT(*entry->evaluations, 100);
    const Entry* hurried = find(report, "auto", {"steps", 1});
    EXPECT_GT(hurried->unresolved, 0U);
    EXPECT_LT(*hurried->evaluations, *entry->evaluations);
}

TEST_F(MeasureTest, has_the_shaders_by_hand_and_the_limit_beside_the_tracers) {
    const PresetReport report = run(small());
    for (const char* name : {"plain sphere", "plain first-order", "limit"}) {
        const Entry* entry = find(report, name);
        ASSERT_NE(entry, nullptr) << name;
        EXPECT_EQ(entry->seconds.size(), 3U);
        EXPECT_NEAR(static_cast<double>(entry->hit), static_cast<double>(find(report, "auto")->hit),
                    12);
    }
    EXPECT_EQ(plain_of(report), find(report, "plain sphere"));
    const Entry* limit = find(report, "limit");
    EXPECT_DOUBLE_EQ(*limit->evaluations, static_cast<double>(limit->hit) / 1200);
}

TEST_F(MeasureTest, judges_by_a_reference_and_tells_the_limit_its_depths) {
    // A wall of the depth 9 in front of the ball, but for its first row.
    oracle::Reference wall{40, 30, 2 * std::tan(10 * std::numbers::pi / 180) / 30, false, {}};
    oracle::Pixel hit;
    hit.verdict = oracle::Verdict::hit;
    hit.near = hit.far = 9;
    hit.normal = {0, 0, 1};
    wall.pixels.assign(1200, hit);
    oracle::Pixel miss;
    miss.verdict = oracle::Verdict::miss;
    miss.near = miss.far = std::numeric_limits<double>::infinity();
    std::fill_n(wall.pixels.begin(), 40, miss);
    wall.pixels[40].verdict = oracle::Verdict::undecided;
    const auto measured = measure(*context, ball(), small(), &wall);
    ASSERT_TRUE(measured);
    const PresetReport& report = measured->report;
    const Entry* entry = find(report, "auto");
    ASSERT_TRUE(entry->errors);
    EXPECT_EQ(entry->errors->undecided, 1U);
    EXPECT_EQ(entry->errors->compared, 1199U);
    EXPECT_EQ(entry->errors->missed + entry->hit, 1200U - 40 - 1);
    // The wall fills the bounds, which are larger than the ball.
    EXPECT_GT(find(report, "limit")->hit, 2 * entry->hit);
    EXPECT_FALSE(find(report, "limit")->errors);
    ASSERT_EQ(measured->pictures.size(), 4U);
    EXPECT_EQ(measured->pictures[0].tracer, "auto");
    EXPECT_EQ(measured->pictures[0].picture.width, 40);
}

TEST_F(MeasureTest, tells_the_passes_of_those_tracers_that_are_asked_for) {
    Options options = small();
    options.passes = {"sphere"};
    const PresetReport report = run(options);
    EXPECT_FALSE(find(report, "auto")->passes);
    EXPECT_FALSE(find(report, "sphere", {"steps", 1})->passes);
    const auto& passes = find(report, "sphere")->passes;
    ASSERT_TRUE(passes);
    for (const double seconds :
         {passes->geometry, passes->normal, passes->shading, passes->shadows}) {
        EXPECT_GT(seconds, 0);
    }
}

TEST(Shares, add_up_to_the_whole_frame) {
    const auto parts = shares({1, 1.5, 2, 4});
    EXPECT_DOUBLE_EQ(parts[0], 0.25);
    EXPECT_DOUBLE_EQ(parts[1], 0.125);
    EXPECT_DOUBLE_EQ(parts[2], 0.125);
    EXPECT_DOUBLE_EQ(parts[3], 0.5);
    // Noise may turn a difference around.
    const auto noisy = shares({2, 1.9, 3, 2.9});
    EXPECT_DOUBLE_EQ(noisy[1], 0);
    EXPECT_DOUBLE_EQ(noisy[3], 0);
    EXPECT_DOUBLE_EQ(std::accumulate(noisy.begin(), noisy.end(), 0.0), 1);
}

}  // namespace
}  // namespace bench
