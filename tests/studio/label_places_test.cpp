// SPDX-License-Identifier: MIT
// Labels that do not cover each other.
#include "studio/label_places.h"

#include <random>

#include <gtest/gtest.h>

namespace {

using studio::label_places;
using studio::LabelledPoint;
using studio::PlotBox;

constexpr PlotBox frame{0, 0, 300, 200};

TEST(LabelPlaces, are_to_the_right_where_there_is_room) {
    const LabelledPoint points[] = {{100, 100, 40, 10}};
    const auto places = label_places(points, frame, 5);
    ASSERT_TRUE(places[0]);
    EXPECT_EQ(places[0]->x, 106);
    EXPECT_EQ(places[0]->y, 95);
}

TEST(LabelPlaces, are_on_the_left_at_the_right_edge) {
    const LabelledPoint points[] = {{295, 100, 40, 10}};
    const auto places = label_places(points, frame, 5);
    ASSERT_TRUE(places[0]);
    EXPECT_EQ(places[0]->x + 40, 289);
}

TEST(LabelPlaces, are_left_out_where_there_is_no_room) {
    const std::vector<LabelledPoint> crowd(12, {100, 100, 60, 10});
    int placed = 0;
    for (const auto& place : label_places(crowd, frame, 5)) placed += place.has_value();
    EXPECT_GT(placed, 0);
    EXPECT_LT(placed, 12);
    const LabelledPoint empty[] = {{100, 100, 0, 10}};
    EXPECT_FALSE(label_places(empty, frame, 5)[0]);
}

TEST(LabelPlaces, never_overlap) {
    constexpr unsigned seed = 11;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> across(0, 300), down(0, 200);
    for (int round = 0; round < 100; ++round) {
        std::vector<LabelledPoint> points;
        for (int i = 0; i < 15; ++i) points.push_back({across(random), down(random), 30, 10});
        std::vector<PlotBox> boxes;
        for (const auto& place : label_places(points, frame, 4)) {
            if (place) boxes.push_back({place->x, place->y, place->x + 30, place->y + 10});
        }
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const PlotBox& a = boxes[i];
            EXPECT_TRUE(a.left >= 0 && a.right <= 300 && a.top >= 0 && a.bottom <= 200);
            for (std::size_t k = 0; k < i; ++k) {
                const PlotBox& b = boxes[k];
                EXPECT_TRUE(a.right <= b.left || b.right <= a.left || a.bottom <= b.top ||
                            b.bottom <= a.top);
            }
            for (const LabelledPoint& p : points) {
                EXPECT_FALSE(p.x > a.left && p.x < a.right && p.y > a.top && p.y < a.bottom);
            }
        }
    }
}

}  // namespace
