// SPDX-License-Identifier: MIT
// The order of drawing, with a made-up clock and made-up costs.
#include "studio/picture_scheduler.h"

#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace {

using studio::DrawingStep;
using studio::PictureScheduler;

constexpr double rest = PictureScheduler::rest_seconds;

/// Draws until nothing is left to do at this moment; the clock stands still.
std::vector<DrawingStep> draw_all(PictureScheduler& scheduler, double now, double pixel_seconds) {
    std::vector<DrawingStep> steps;
    while (const auto step = scheduler.next(now)) {
        steps.push_back(*step);
        scheduler.done(*step, pixel_seconds * step->tile.width * step->tile.height);
        if (steps.size() > 100000) break;
    }
    return steps;
}

/// How often each pixel of the last picture in these steps is drawn.
std::vector<int> coverage(const std::vector<DrawingStep>& steps, int width, int height) {
    std::vector<int> count(static_cast<std::size_t>(width) * height);
    for (const DrawingStep& step : steps) {
        for (int y = step.tile.y; y < step.tile.y + step.tile.height; ++y) {
            for (int x = step.tile.x; x < step.tile.x + step.tile.width; ++x) {
                ++count.at(static_cast<std::size_t>(y) * width + x);
            }
        }
    }
    return count;
}

std::vector<DrawingStep> of_divisor(const std::vector<DrawingStep>& steps,
                                    const std::function<bool(int)>& wanted) {
    std::vector<DrawingStep> result;
    for (const DrawingStep& step : steps) {
        if (wanted(step.divisor)) result.push_back(step);
    }
    return result;
}

/// A scheduler that has drawn one picture of this cost and rests.
PictureScheduler settled(int width, int height, double pixel_seconds) {
    PictureScheduler scheduler;
    scheduler.resize(width, height, 0);
    draw_all(scheduler, 0, pixel_seconds);
    draw_all(scheduler, 10, pixel_seconds);
    return scheduler;
}

TEST(PictureScheduler, draws_nothing_before_there_is_a_size) {
    PictureScheduler scheduler;
    EXPECT_FALSE(scheduler.next(0));
    scheduler.change(0);
    EXPECT_FALSE(scheduler.next(100));
    EXPECT_EQ(scheduler.wait(100), std::numeric_limits<double>::infinity());
}

TEST(PictureScheduler, draws_nothing_when_nothing_has_changed) {
    PictureScheduler scheduler = settled(640, 480, 1e-6);
    EXPECT_TRUE(scheduler.complete());
    EXPECT_FALSE(scheduler.next(20));
    scheduler.resize(640, 480, 20);
    EXPECT_FALSE(scheduler.next(20));
    EXPECT_EQ(scheduler.wait(20), std::numeric_limits<double>::infinity());
}

TEST(PictureScheduler, draws_a_costly_scene_coarse_while_it_moves_and_full_when_it_rests) {
    PictureScheduler scheduler = settled(800, 600, 1e-6);
    for (const double now : {20.0, 20.05, 20.1}) {
        scheduler.change(now);
        const auto steps = draw_all(scheduler, now, 1e-6);
        ASSERT_FALSE(steps.empty());
        EXPECT_TRUE(of_divisor(steps, [](int d) { return d == 1; }).empty());
    }
    EXPECT_NEAR(scheduler.wait(20.15), rest - 0.05, 1e-9);
    EXPECT_FALSE(scheduler.next(20.15));
    const auto full = draw_all(scheduler, 20.1 + rest + 1e-6, 1e-6);
    ASSERT_FALSE(full.empty());
    for (const DrawingStep& step : full) EXPECT_EQ(step.divisor, 1);
    EXPECT_TRUE(scheduler.complete());
}

TEST(PictureScheduler, draws_a_cheap_scene_full_at_once) {
    PictureScheduler scheduler = settled(800, 600, 1e-9);
    scheduler.change(20);
    const auto steps = draw_all(scheduler, 20, 1e-9);
    ASSERT_FALSE(steps.empty());
    for (const DrawingStep& step : steps) EXPECT_EQ(step.divisor, 1);
}

TEST(PictureScheduler, keeps_the_coarse_picture_within_its_time) {
    for (const double cost : {1e-7, 3e-7, 1e-6}) {
        PictureScheduler scheduler = settled(1000, 700, cost);
        scheduler.change(20);
        const auto steps = draw_all(scheduler, 20, cost);
        ASSERT_FALSE(steps.empty());
        const double seconds = cost * steps.front().width * steps.front().height;
        EXPECT_LE(seconds, PictureScheduler::coarse_seconds) << "at " << cost << " s a pixel";
    }
}

TEST(PictureScheduler, covers_every_pixel_exactly_once) {
    for (const double cost : {1e-8, 1e-6, 2e-5}) {
        PictureScheduler scheduler = settled(333, 217, cost);
        scheduler.change(20);
        draw_all(scheduler, 20, cost);
        scheduler.change(30);
        auto steps = draw_all(scheduler, 30, cost);
        const auto later = draw_all(scheduler, 30 + 2 * rest, cost);
        steps.insert(steps.end(), later.begin(), later.end());
        const auto full = of_divisor(steps, [](int d) { return d == 1; });
        const auto coarse = of_divisor(steps, [](int d) { return d > 1; });
        EXPECT_EQ(coverage(full, 333, 217), std::vector<int>(333 * 217, 1));
        EXPECT_TRUE(full.front().first && full.back().last);
        if (coarse.empty()) continue;
        const int width = coarse.front().width, height = coarse.front().height;
        EXPECT_EQ(coverage(coarse, width, height), std::vector<int>(width * height, 1));
    }
}

TEST(PictureScheduler, splits_tiles_that_turn_out_costly) {
    PictureScheduler scheduler = settled(1024, 1024, 1e-8);
    scheduler.change(20);
    std::vector<DrawingStep> steps;
    while (const auto step = scheduler.next(20)) {
        steps.push_back(*step);
        scheduler.done(*step, 1e-5 * step->tile.width * step->tile.height);
    }
    ASSERT_GT(steps.size(), 4u);
    EXPECT_LT(steps.back().tile.width, steps.front().tile.width);
    EXPECT_EQ(coverage(steps, 1024, 1024), std::vector<int>(1024 * 1024, 1));
}

TEST(PictureScheduler, aims_at_tiles_of_its_time) {
    constexpr double cost = 1e-6;
    PictureScheduler scheduler = settled(1024, 768, cost);
    scheduler.change(20);
    draw_all(scheduler, 20, cost);
    for (const DrawingStep& step : draw_all(scheduler, 21, cost)) {
        EXPECT_LE(cost * step.tile.width * step.tile.height, PictureScheduler::tile_seconds);
    }
}

TEST(PictureScheduler, finishes_a_coarse_picture_although_the_scene_moves_on) {
    PictureScheduler scheduler = settled(800, 600, 1e-6);
    scheduler.change(20);
    const auto begun = scheduler.next(20);
    ASSERT_TRUE(begun && begun->first && !begun->last);
    scheduler.done(*begun, 1e-3);
    int finished = 0;
    for (int i = 0; i < 1000 && finished < 2; ++i) {
        // A change before every tile.
        scheduler.change(20 + 0.01 * i);
        const auto step = scheduler.next(20 + 0.01 * i);
        ASSERT_TRUE(step);
        EXPECT_GT(step->divisor, 1);
        scheduler.done(*step, 1e-6 * step->tile.width * step->tile.height);
        finished += step->last;
    }
    EXPECT_EQ(finished, 2);
}

TEST(PictureScheduler, gives_a_full_picture_up_when_the_scene_changes) {
    PictureScheduler scheduler = settled(800, 600, 1e-6);
    scheduler.change(20);
    draw_all(scheduler, 20, 1e-6);
    const auto full = scheduler.next(21);
    ASSERT_TRUE(full && full->full() && !full->last);
    scheduler.done(*full, 1e-3);
    scheduler.change(21);
    const auto next = scheduler.next(21);
    ASSERT_TRUE(next);
    EXPECT_FALSE(next->full());
    EXPECT_TRUE(next->first);
}

TEST(PictureScheduler, begins_a_new_program_with_a_coarse_picture_in_small_tiles) {
    PictureScheduler scheduler = settled(800, 600, 1e-9);
    scheduler.restart(20);
    const auto step = scheduler.next(20);
    ASSERT_TRUE(step);
    EXPECT_GT(step->divisor, 1);
    EXPECT_LE(step->tile.width, 64);
    EXPECT_LE(step->tile.height, 64);
}

TEST(PictureScheduler, begins_with_the_first_pass_that_the_full_picture_lacks) {
    using render::Pass;
    PictureScheduler scheduler = settled(800, 600, 1e-6);
    const auto first_pass = [&](double now) { return scheduler.next(now)->pass; };
    scheduler.change(20, Pass::image);
    EXPECT_EQ(first_pass(20), Pass::image);
    scheduler.change(21, Pass::light);
    EXPECT_EQ(draw_all(scheduler, 21, 1e-6).back().pass, Pass::light);
    // The full picture has not been lit yet.
    scheduler.change(22, Pass::image);
    EXPECT_EQ(first_pass(22), Pass::light);
    draw_all(scheduler, 22, 1e-6);
    draw_all(scheduler, 22 + 2 * rest, 1e-6);
    ASSERT_TRUE(scheduler.complete());
    scheduler.change(30, Pass::image);
    EXPECT_EQ(first_pass(30), Pass::image);
    scheduler.change(31);
    draw_all(scheduler, 31, 1e-6);
    scheduler.change(32, Pass::light);
    EXPECT_EQ(first_pass(32), Pass::geometry);
    draw_all(scheduler, 32, 1e-6);
    draw_all(scheduler, 32 + 2 * rest, 1e-6);
    scheduler.restart(40);
    EXPECT_EQ(first_pass(40), Pass::geometry);
}

TEST(PictureScheduler, learns_what_each_pass_costs) {
    PictureScheduler scheduler = settled(800, 600, 1e-6);
    scheduler.change(20, render::Pass::light);
    EXPECT_GT(scheduler.next(20)->divisor, 1) << "as all passes, as long as it is not known";
    draw_all(scheduler, 20, 1e-9);
    draw_all(scheduler, 20 + 2 * rest, 1e-9);
    scheduler.change(30, render::Pass::light);
    EXPECT_EQ(scheduler.next(30)->divisor, 1);
    draw_all(scheduler, 30, 1e-9);
    scheduler.change(40);
    EXPECT_GT(scheduler.next(40)->divisor, 1);
}

TEST(PictureScheduler, begins_in_the_middle) {
    PictureScheduler scheduler = settled(800, 600, 1e-6);
    scheduler.change(20);
    draw_all(scheduler, 20, 1e-6);
    const auto step = scheduler.next(21);
    ASSERT_TRUE(step);
    EXPECT_NEAR(step->tile.x + step->tile.width / 2.0, 400, step->tile.width);
    EXPECT_NEAR(step->tile.y + step->tile.height / 2.0, 300, step->tile.height);
}

TEST(PictureScheduler, reports_the_drawing_time_of_the_full_picture) {
    PictureScheduler scheduler = settled(100, 100, 1e-6);
    EXPECT_NEAR(scheduler.full_seconds(), 0.01, 1e-9);
}

}  // namespace
