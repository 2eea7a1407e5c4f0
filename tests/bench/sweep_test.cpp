// SPDX-License-Identifier: MIT
#include "bench/sweep.h"

#include <gtest/gtest.h>

namespace bench {
namespace {

std::string refusal(std::string_view text) {
    const auto sweep = read_sweep(text);
    return sweep ? "" : sweep.problems()[0].message;
}

TEST(Sweep, is_a_name_and_values) {
    const auto sweep = read_sweep("lipschitz=0.25,1,2e1");
    ASSERT_TRUE(sweep);
    EXPECT_EQ(sweep->name, "lipschitz");
    EXPECT_EQ(sweep->values, (std::vector<double>{0.25, 1, 20}));
}

TEST(Sweep, refuses_what_is_no_setting) {
    for (const char* text : {"", "shadow=1", "lipschitz", "=1"}) {
        EXPECT_EQ(refusal(text), "'" + std::string(text) +
                                     "' should be lipschitz=, steps= or epsilon= and values, such "
                                     "as lipschitz=0.5,1,2");
    }
}

TEST(Sweep, refuses_what_is_no_value) {
    EXPECT_EQ(refusal("steps=0"), "'0' is no value of steps; it goes from 1 to 100000");
    EXPECT_EQ(refusal("lipschitz=1,,2"),
              "'' is no value of lipschitz; it goes from 0.001 to 1000000");
    for (const char* text : {"epsilon=nan", "epsilon=0", "epsilon=1x", "epsilon=", "epsilon=1,"}) {
        EXPECT_NE(refusal(text), "") << text;
    }
}

TEST(Sweep, moves_one_setting_at_a_time_and_starts_with_none) {
    scene::Settings settings;
    settings.lipschitz = 2;
    const auto list = moves({{"lipschitz", {1, 2, 4, 4}}, {"steps", {64}}}, settings);
    EXPECT_EQ(list, (std::vector<Move>{{}, {"lipschitz", 1}, {"lipschitz", 4}, {"steps", 64}}));
}

TEST(Sweep, a_move_sets_its_setting_and_no_other) {
    const scene::Settings settings;
    EXPECT_EQ(moved(settings, {}), settings);
    scene::Settings expected = settings;
    expected.epsilon = 0.5;
    EXPECT_EQ(moved(settings, {"epsilon", 0.5}), expected);
    expected = settings;
    expected.steps = 64;
    EXPECT_EQ(moved(settings, {"steps", 64}), expected);
    EXPECT_EQ(text(Move{"steps", 64}), "steps 64");
    EXPECT_EQ(text(Move{}), "as set");
}

}  // namespace
}  // namespace bench
