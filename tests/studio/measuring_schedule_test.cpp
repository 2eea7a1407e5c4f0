// SPDX-License-Identifier: MIT
// The order of measuring.
#include "studio/measuring_schedule.h"

#include <algorithm>
#include <map>
#include <vector>

#include <gtest/gtest.h>

namespace {

using studio::MeasuringSchedule;

/// Runs it to its end, each setting taking its own time; the turns by setting.
std::vector<MeasuringSchedule::Turn> run(MeasuringSchedule schedule,
                                         const std::vector<double>& seconds) {
    std::vector<MeasuringSchedule::Turn> turns;
    double last_progress = 0;
    while (const auto turn = schedule.next()) {
        turns.push_back(*turn);
        schedule.done(seconds[turn->setting]);
        EXPECT_GE(schedule.progress(), last_progress);
        last_progress = schedule.progress();
        if (turns.size() > 10000) break;
    }
    EXPECT_EQ(schedule.progress(), 1);
    return turns;
}

TEST(MeasuringSchedule, gives_every_setting_one_turn_a_round_and_counts_all_but_the_first) {
    const auto turns = run(MeasuringSchedule(3, 1.0), {0.1, 0.2, 0.3});
    ASSERT_EQ(turns.size() % 3, 0u);
    for (std::size_t round = 0; round < turns.size() / 3; ++round) {
        std::vector<std::size_t> settings;
        for (std::size_t i = 0; i < 3; ++i) {
            settings.push_back(turns[3 * round + i].setting);
            EXPECT_EQ(turns[3 * round + i].counts, round > 0);
        }
        std::ranges::sort(settings);
        EXPECT_EQ(settings, (std::vector<std::size_t>{0, 1, 2}));
    }
}

TEST(MeasuringSchedule, begins_each_round_with_another_setting) {
    const auto turns = run(MeasuringSchedule(3, 1.0), {0.1, 0.2, 0.3});
    EXPECT_EQ(turns[0].setting, 0u);
    EXPECT_EQ(turns[3].setting, 1u);
    EXPECT_EQ(turns[4].setting, 2u);
    EXPECT_EQ(turns[5].setting, 0u);
    EXPECT_EQ(turns[6].setting, 2u);
}

TEST(MeasuringSchedule, ends_between_the_least_and_the_most_rounds) {
    const auto rounds = [](double seconds) {
        return static_cast<int>(run(MeasuringSchedule(1, 1.0), {seconds}).size()) - 1;
    };
    EXPECT_EQ(rounds(100), MeasuringSchedule::least_rounds);
    EXPECT_EQ(rounds(1e-6), MeasuringSchedule::most_rounds);
    EXPECT_EQ(rounds(0.125), 8);
}

TEST(MeasuringSchedule, expects_what_a_setting_has_taken_at_best) {
    MeasuringSchedule schedule(2, 1.0);
    EXPECT_EQ(schedule.next()->expected_seconds, 0);
    schedule.done(0.5);
    EXPECT_EQ(schedule.next()->expected_seconds, 0);
    schedule.done(0.3);
    // The second round begins with setting 1.
    EXPECT_EQ(schedule.next()->expected_seconds, 0.3);
    schedule.done(0.2);
    EXPECT_EQ(schedule.next()->expected_seconds, 0.5);
    schedule.done(0.6);
    EXPECT_EQ(schedule.next()->expected_seconds, 0.5);
    schedule.done(0.6);
    EXPECT_EQ(schedule.next()->expected_seconds, 0.2);
}

TEST(MeasuringSchedule, goes_on_without_what_cannot_be_drawn) {
    MeasuringSchedule schedule(3, 1.0);
    schedule.done(0.1);
    schedule.drop();
    std::map<std::size_t, int> turns;
    while (const auto turn = schedule.next()) {
        ++turns[turn->setting];
        schedule.done(0.1);
    }
    EXPECT_EQ(turns.count(1), 0u);
    EXPECT_EQ(turns[0] + 1, turns[2]);
    MeasuringSchedule nothing(1, 1.0);
    nothing.drop();
    EXPECT_FALSE(nothing.next());
    EXPECT_FALSE(MeasuringSchedule(0, 1.0).next());
}

}  // namespace
