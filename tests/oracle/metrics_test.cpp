// SPDX-License-Identifier: MIT
#include "oracle/metrics.h"

#include <cmath>

#include <gtest/gtest.h>

#include "oracle/hand_made.h"
#include "property.h"

namespace {

using hand_made::fragile;
using hand_made::hit;
using hand_made::infinity;
using hand_made::miss;
using hand_made::nan;
using hand_made::row;
using hand_made::shot;
using hand_made::undecided;
using oracle::Judgement;
using oracle::Metrics;

Metrics metrics_of(const oracle::Reference& reference, const oracle::Shot& shot) {
    const auto metrics = oracle::compare(reference, shot);
    EXPECT_TRUE(metrics);
    return metrics ? *metrics : Metrics{};
}

Judgement judgement(oracle::Pixel pixel, float got) {
    return metrics_of(row({pixel}), shot({got})).judgements.at(0);
}

TEST(Metrics, judges_each_pixel) {
    EXPECT_EQ(judgement(hit(2), 2), Judgement::right);
    EXPECT_EQ(judgement(miss(), infinity), Judgement::right);
    EXPECT_EQ(judgement(hit(2), infinity), Judgement::missed);
    EXPECT_EQ(judgement(miss(), 2), Judgement::phantom);
    EXPECT_EQ(judgement(hit(2), 3), Judgement::moved);
    EXPECT_EQ(judgement(undecided(1, 2), infinity), Judgement::excused);
    EXPECT_EQ(judgement(fragile(miss()), 2), Judgement::excused);
}

TEST(Metrics, allows_half_a_footprint_of_depth_on_both_sides) {
    EXPECT_EQ(judgement(hit(2), 2.0099f), Judgement::right);
    EXPECT_EQ(judgement(hit(2), 2.0101f), Judgement::moved);
    EXPECT_EQ(judgement(hit(2), 1.9901f), Judgement::right);
    EXPECT_EQ(judgement(hit(2), 1.9899f), Judgement::moved);
}

TEST(Metrics, takes_half_a_footprint_from_the_enclosure_of_the_depth) {
    oracle::Pixel wide = hit(2);
    wide.far = 2.5;
    EXPECT_EQ(judgement(wide, 2.3f), Judgement::right);
    EXPECT_EQ(judgement(wide, 2.511f), Judgement::right);  // half a footprint at 2.25 is 0.01125
    EXPECT_EQ(judgement(wide, 2.512f), Judgement::moved);
}

TEST(Metrics, wants_the_depth_0_for_an_eye_inside) {
    EXPECT_EQ(judgement(hit(0), 0), Judgement::right);
    EXPECT_EQ(judgement(hit(0), -0.0f), Judgement::right);
    EXPECT_EQ(judgement(hit(0), 1e-6f), Judgement::moved);
    EXPECT_EQ(judgement(hit(0), infinity), Judgement::missed);
    EXPECT_EQ(metrics_of(row({hit(0)}), shot({0})).depth_error.largest, 0);
}

TEST(Metrics, counts_what_is_no_depth_as_wrong) {
    const Metrics m = metrics_of(row({hit(1), miss(), hit(1), miss(), hit(1), undecided(0, 1)}),
                                 shot({nan, nan, -1, -infinity, infinity, nan}));
    EXPECT_EQ(m.missed, 3u);
    EXPECT_EQ(m.phantom, 2u);
    EXPECT_EQ(m.moved, 0u);
    EXPECT_EQ(m.no_depth, 4u);
}

TEST(Metrics, counts_pixels) {
    const Metrics m = metrics_of(
        row({hit(1), hit(1), hit(1), miss(), miss(), undecided(1, 2), fragile(undecided(1, 2)),
             fragile(hit(1)), fragile(miss()), fragile(miss())}),
        shot({1, 2, infinity, infinity, 1, 1, 1, 7, 7, infinity}));
    EXPECT_EQ(m.compared, 5u);
    EXPECT_EQ(m.undecided, 2u);
    EXPECT_EQ(m.fragile, 3u);
    EXPECT_EQ(m.moved, 1u);
    EXPECT_EQ(m.missed, 1u);
    EXPECT_EQ(m.phantom, 1u);
    EXPECT_EQ(m.wrong(), 3u);
    EXPECT_EQ(m.judgements.size(), 10u);
}

TEST(Metrics, counts_given_up_pixels_beside_their_judgement) {
    oracle::Shot got = shot({1, 2, 1, 1});
    got.gave_up = {true, true, false, true};
    const Metrics m = metrics_of(row({hit(1), hit(1), hit(1), undecided(1, 2)}), got);
    EXPECT_EQ(m.gave_up, 2u);
    EXPECT_EQ(m.moved, 1u);
}

TEST(Metrics, spreads_relative_depth_errors_of_right_hits_alone) {
    // Errors of 1/1024, 2/1024 and 4/1024; one moved, one excused, one miss.
    const Metrics m = metrics_of(row({hit(1), hit(1), hit(2), hit(1), fragile(hit(1)), miss()}),
                                 shot({1 - 0x1p-10f, 1 + 0x1p-8f, 2 + 0x1p-8f, 3, 1.1f, infinity}));
    EXPECT_DOUBLE_EQ(m.depth_error.median, 0x1p-9);
    EXPECT_DOUBLE_EQ(m.depth_error.percentile_99, 0x1p-8);
    EXPECT_DOUBLE_EQ(m.depth_error.largest, 0x1p-8);
}

TEST(Metrics, takes_percentiles_from_the_set) {
    std::vector<oracle::Pixel> pixels;
    std::vector<float> depths;
    for (int i = 1; i <= 200; ++i) {
        pixels.push_back(hit(1));
        depths.push_back(1 + static_cast<float>(i) * 0x1p-20f);
    }
    const Metrics m = metrics_of(row(pixels), shot(depths));
    EXPECT_DOUBLE_EQ(m.depth_error.median, 100 * 0x1p-20);
    EXPECT_DOUBLE_EQ(m.depth_error.percentile_99, 198 * 0x1p-20);
    EXPECT_DOUBLE_EQ(m.depth_error.largest, 200 * 0x1p-20);
}

TEST(Metrics, measures_angles_of_normals_in_degrees) {
    oracle::Shot got = shot({1, 1, 1, 1, 5, infinity});
    got.normal = image::Vectors(6, 1);
    // 45 degrees off, of another length, zero, without a reference, moved, a miss.
    got.normal.values = {0, 1, 1, 0, 0, 2, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0};
    const Metrics m =
        metrics_of(row({hit(1), hit(1), hit(1), hit(1, glm::dvec3(0)), hit(1), miss()}), got);
    EXPECT_NEAR(m.normal_error.median, 45, 1e-6);
    EXPECT_DOUBLE_EQ(m.normal_error.largest, 180);
}

TEST(Metrics, measures_small_angles) {
    oracle::Shot got = shot({1});
    got.normal = image::Vectors(1, 1);
    got.normal.values = {1e-6f, 0, 1};
    const Metrics m = metrics_of(row({hit(1)}), got);
    EXPECT_NEAR(m.normal_error.largest, 5.7296e-5, 1e-8);
}

TEST(Metrics, counts_a_normal_that_is_not_a_number_as_opposite) {
    oracle::Shot got = shot({1});
    got.normal = image::Vectors(1, 1);
    got.normal.values = {nan, 0, 1};
    EXPECT_EQ(metrics_of(row({hit(1)}), got).normal_error.largest, 180);
}

TEST(Metrics, refuses_sizes_that_differ) {
    const auto depth = oracle::compare(row({hit(1), hit(1)}), shot({1}));
    ASSERT_FALSE(depth);
    EXPECT_EQ(depth.problems()[0].message,
              "the reference has 2x1 pixels, the depth 1x1; compare pictures of one size");
    oracle::Shot got = shot({1});
    got.normal = image::Vectors(2, 2);
    const auto normal = oracle::compare(row({hit(1)}), got);
    ASSERT_FALSE(normal);
    EXPECT_EQ(normal.problems()[0].message,
              "the reference has 1x1 pixels, the normal 2x2; compare pictures of one size");
}

/// A random row: hits between 0.01 and 1e4, and misses.
std::vector<oracle::Pixel> random_pixels(const std::vector<int>& seeds) {
    std::vector<oracle::Pixel> pixels;
    for (const int seed : seeds) {
        const double exponent = std::fmod(std::abs(static_cast<double>(seed)) * 0.61803, 6.0) - 2;
        pixels.push_back(seed % 3 == 0 ? miss() : hit(std::pow(10.0, exponent)));
    }
    return pixels;
}

/// The reference's depths, each moved by so many footprints.
oracle::Shot moved(const oracle::Reference& reference, double footprints) {
    std::vector<float> depths;
    for (const oracle::Pixel& pixel : reference.pixels) {
        depths.push_back(
            pixel.verdict == oracle::Verdict::miss
                ? infinity
                : static_cast<float>(pixel.near * (1 + footprints * reference.pixel_width)));
    }
    return shot(depths);
}

TEST(MetricsProperty, a_picture_compared_with_itself_is_right) {
    expect_property(20260701, 200, 50, [](const std::vector<int>& seeds) {
        const oracle::Reference reference = row(random_pixels(seeds));
        const Metrics m = metrics_of(reference, moved(reference, 0));
        RC_ASSERT(m.wrong() == 0);
        RC_ASSERT(m.compared == seeds.size());
        RC_ASSERT(m.depth_error.largest <= 0x1p-24);
    });
}

TEST(MetricsProperty, half_a_footprint_is_the_border) {
    expect_property(20260702, 200, 50, [](const std::vector<int>& seeds, bool nearer) {
        const oracle::Reference reference = row(random_pixels(seeds));
        std::size_t hits = 0;
        for (const oracle::Pixel& p : reference.pixels) hits += p.verdict == oracle::Verdict::hit;
        const double side = nearer ? -1 : 1;
        RC_ASSERT(metrics_of(reference, moved(reference, side * 0.49)).wrong() == 0);
        RC_ASSERT(metrics_of(reference, moved(reference, side * 0.51)).moved == hits);
    });
}

}  // namespace
