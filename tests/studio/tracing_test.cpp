// SPDX-License-Identifier: MIT
// Which settings the present one is compared with.
#include "studio/tracing.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "shader/program_source.h"

namespace {

using studio::Tracing;

TEST(Tracing, comes_from_settings_and_goes_back) {
    scene::Settings settings{.tracer = "sphere", .steps = 7, .lipschitz = 3, .epsilon = 2};
    scene::Settings other{.exposure = 4};
    apply(studio::tracing_of(settings), other);
    settings.exposure = 4;
    EXPECT_EQ(other, settings);
}

TEST(Tracing, has_the_present_setting_first_and_each_tracer_among_its_neighbours) {
    const Tracing present{"sphere", 0.9, 100, 0.5};
    const auto list = studio::neighbours(present);
    EXPECT_EQ(list.front(), present);
    std::set<std::string> tracers;
    std::set<double> scales;
    for (const Tracing& tracing : list) {
        EXPECT_EQ(tracing.steps, 100);
        EXPECT_EQ(tracing.epsilon, 0.5);
        EXPECT_EQ(std::ranges::count(list, tracing), 1);
        tracers.insert(tracing.tracer);
        if (tracing.tracer == "sphere") {
            scales.insert(tracing.lipschitz);
        } else {
            EXPECT_EQ(tracing.lipschitz, 1);
        }
    }
    EXPECT_EQ(tracers.size(), shader::tracers().size());
    EXPECT_EQ(scales, (std::set<double>{0.25, 0.5, 0.7, 0.9, 1, 1.4, 2}));
}

TEST(Tracing, is_there_once_where_the_present_scale_is_one_of_the_sweep) {
    const auto list = studio::neighbours({"auto", 1, 1024, 0.1});
    EXPECT_EQ(std::ranges::count(list, std::string("auto"), &Tracing::tracer), 6);
}

TEST(Tracing, is_described_by_tracer_and_scale) {
    EXPECT_EQ(studio::describe({"sphere", 0.7, 10, 1}), "sphere, Lipschitz scale 0.7");
}

}  // namespace
