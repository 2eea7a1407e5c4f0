// SPDX-License-Identifier: MIT
#include "bench/baseline.h"

#include <gtest/gtest.h>

#include "bench/hand_made.h"

namespace bench {
namespace {

/// A run of one entry whose times have some noise, on a machine that slows down for a while, and
/// that is `slowness` times as slow as a whole.
Report noisy_run(double seconds, double slowness, std::mt19937& random) {
    std::normal_distribution<double> noise(0, 0.02);
    Report report = hand_made();
    PresetReport& preset = report.presets[0];
    preset.yardstick_seconds.clear();
    preset.entries.resize(1);
    preset.entries[0].seconds.clear();
    for (int round = 0; round < 7; ++round) {
        const double moment = slowness * (round > 3 ? 2.5 : 1);
        preset.yardstick_seconds.push_back(moment * 1e-3 * std::exp(noise(random)));
        preset.entries[0].seconds.push_back(moment * seconds * std::exp(noise(random)));
    }
    return report;
}

Change only_change(const Report& before, const Report& now) {
    const auto list = changes(before, now);
    EXPECT_TRUE(list);
    EXPECT_EQ(list->size(), 1U);
    return (*list)[0];
}

TEST(Baseline, says_nothing_about_noise) {
    std::mt19937 random(5);
    int verdicts = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const Report before = noisy_run(4e-3, 1, random), now = noisy_run(4e-3, 1.7, random);
        verdicts += only_change(before, now).speed != Speed::same;
    }
    EXPECT_LE(verdicts, 1);
}

TEST(Baseline, sees_a_quarter_more_whatever_the_machine_does) {
    std::mt19937 random(6);
    int slower = 0, faster = 0;
    for (int trial = 0; trial < 100; ++trial) {
        const Report before = noisy_run(4e-3, 1, random), now = noisy_run(5e-3, 0.6, random);
        slower += only_change(before, now).speed == Speed::slower;
        faster += only_change(now, before).speed == Speed::faster;
    }
    EXPECT_GE(slower, 97);
    EXPECT_GE(faster, 97);
}

TEST(Baseline, a_verdict_needs_the_whole_interval) {
    EXPECT_EQ(speed({0.9, 1.2}), Speed::same);
    EXPECT_EQ(speed({1.05, 1.2}), Speed::same);
    EXPECT_EQ(speed({1.09, 1.2}), Speed::slower);
    EXPECT_EQ(speed({0.7, 0.95}), Speed::same);
    EXPECT_EQ(speed({0.7, 0.92}), Speed::faster);
}

TEST(Baseline, wrong_pixels_differ_by_more_than_chance) {
    EXPECT_EQ(accuracy(100, 119), Accuracy::same);
    EXPECT_EQ(accuracy(100, 125), Accuracy::worse);
    EXPECT_EQ(accuracy(0, 4), Accuracy::same);
    EXPECT_EQ(accuracy(0, 5), Accuracy::worse);
    EXPECT_EQ(accuracy(5, 0), Accuracy::better);
}

TEST(Baseline, compares_what_both_runs_have) {
    Report before = hand_made(), now = hand_made();
    before.presets[0].entries.erase(before.presets[0].entries.begin());
    now.presets[0].entries[3].errors->phantom = 40;
    now.presets.push_back(now.presets[0]);
    now.presets.back().preset = "surfaces/new";
    const auto list = changes(before, now);
    ASSERT_TRUE(list);
    ASSERT_EQ(list->size(), 5U);
    EXPECT_TRUE(has_regression(*list));
    EXPECT_EQ(
        changes_text(*list),
        "surfaces/ball, sphere, lipschitz 2: more wrong (40 wrong pixels instead of 5)\n"
        "4 of 5 configurations are the same, within the noise; all take 1.000 times the time, "
        "by the geometric mean\n");
    EXPECT_FALSE(has_regression(*changes(now, hand_made())));
}

TEST(Baseline, tells_how_much_slower) {
    Report now = hand_made();
    for (double& seconds : now.presets[0].entries[0].seconds) seconds *= 2;
    const auto list = changes(hand_made(), now);
    ASSERT_TRUE(list);
    EXPECT_TRUE(changes_text(*list).starts_with(
        "surfaces/ball, auto, as set: slower (2.00 times the time, 2.00 to 2.00)\n"));
    EXPECT_TRUE(has_regression(*list));
}

TEST(Baseline, needs_the_same_size) {
    Report before = hand_made();
    before.width = 80;
    const auto list = changes(before, hand_made());
    ASSERT_FALSE(list);
    EXPECT_EQ(list.problems()[0].message,
              "the baseline was drawn with 80x30 pixels; measure with --size 80x30 to compare");
}

TEST(Baseline, leaves_errors_open_that_were_counted_at_another_size) {
    Report before = hand_made();
    before.reference_width = 10;
    const auto list = changes(before, hand_made());
    ASSERT_TRUE(list);
    for (const Change& change : *list) {
        EXPECT_EQ(change.accuracy, Accuracy::unknown);
    }
}

}  // namespace
}  // namespace bench
