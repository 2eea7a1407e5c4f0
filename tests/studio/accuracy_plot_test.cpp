// SPDX-License-Identifier: MIT
// What the plot shows of the measured settings.
#include "studio/accuracy_plot.h"

#include <gtest/gtest.h>

namespace {

using studio::Accuracy;
using studio::Tracing;

const Tracing present{"auto", 0.5, 64, 0.1};

studio::MeasuredSetting setting(const Tracing& tracing, std::size_t missed, double seconds) {
    oracle::Metrics metrics;
    metrics.missed = missed;
    return {
        tracing, std::make_shared<const studio::Judged>(studio::Judged{metrics, {}}), {seconds}};
}

Accuracy measured() {
    Accuracy accuracy;
    accuracy.measured = {setting({"auto", 1, 64, 0.1}, 0, 0.004),
                         setting({"auto", 0.25, 64, 0.1}, 80, 0.001), setting(present, 7, 0.002),
                         setting({"sphere", 1, 64, 0.1}, 0, 0.03),
                         setting({"auto", 1, 99, 0.1}, 3, 0.005)};
    return accuracy;
}

TEST(AccuracyPlot, has_the_present_setting_first_and_marked) {
    const auto plot = studio::accuracy_plot(measured(), present);
    ASSERT_EQ(plot.points.size(), 5u);
    EXPECT_TRUE(plot.points[0].present);
    EXPECT_EQ(plot.points[0].index, 2u);
    EXPECT_EQ(plot.points[0].wrong, 7);
    EXPECT_DOUBLE_EQ(plot.points[0].milliseconds, 2);
    for (std::size_t i = 1; i < 5; ++i) EXPECT_FALSE(plot.points[i].present);
}

TEST(AccuracyPlot, joins_the_scales_of_a_tracer_in_their_order) {
    const auto plot = studio::accuracy_plot(measured(), present);
    ASSERT_EQ(plot.curves.size(), 1u);
    std::vector<std::string> labels;
    for (const std::size_t point : plot.curves[0]) labels.push_back(plot.points[point].label);
    EXPECT_EQ(labels, (std::vector<std::string>{"auto 0.25", "0.5", "1"}));
}

TEST(AccuracyPlot, labels_a_single_point_by_its_tracer_and_other_steps_not_at_all) {
    const auto plot = studio::accuracy_plot(measured(), present);
    for (const auto& point : plot.points) {
        if (point.index == 3) {
            EXPECT_EQ(point.label, "sphere");
        }
        EXPECT_EQ(point.alike, point.index != 4);
        if (point.index == 4) {
            EXPECT_EQ(point.label, "");
        }
    }
}

TEST(AccuracyPlot, has_axes_that_hold_all_points) {
    const auto plot = studio::accuracy_plot(measured(), present);
    EXPECT_EQ(plot.milliseconds.low, 1);
    EXPECT_EQ(plot.milliseconds.high, 50);
    EXPECT_FALSE(plot.milliseconds.zero);
    EXPECT_EQ(plot.wrong.low, 2);
    EXPECT_EQ(plot.wrong.high, 100);
    EXPECT_TRUE(plot.wrong.zero);
}

TEST(AccuracyPlot, leaves_out_what_is_not_judged_or_not_timed) {
    Accuracy accuracy = measured();
    accuracy.measured[0].judged.reset();
    accuracy.measured[1].seconds.clear();
    EXPECT_EQ(studio::accuracy_plot(accuracy, present).points.size(), 3u);
    EXPECT_TRUE(studio::accuracy_plot({}, present).points.empty());
}

}  // namespace
