// SPDX-License-Identifier: MIT
// Where a picture is wrong, as rectangles.
#include "studio/marked_areas.h"

#include <random>

#include <gtest/gtest.h>

namespace {

using oracle::Judgement;
using oracle::Verdict;

struct Case {
    oracle::Reference reference;
    oracle::Metrics metrics;
};

/// m missed, p phantom, v moved, u undecided, f fragile, . right
Case picture(int width, const std::string& text) {
    Case made;
    made.reference.width = width;
    made.reference.height = static_cast<int>(text.size()) / width;
    for (const char letter : text) {
        const bool undecided = letter == 'u';
        made.reference.pixels.push_back(
            {.verdict = undecided ? Verdict::undecided : Verdict::hit, .fragile = letter == 'f'});
        made.metrics.judgements.push_back(letter == 'm'   ? Judgement::missed
                                          : letter == 'p' ? Judgement::phantom
                                          : letter == 'v' ? Judgement::moved
                                          : letter == '.' ? Judgement::right
                                                          : Judgement::excused);
    }
    return made;
}

TEST(MarkedAreas, are_as_large_as_their_judgement_reaches) {
    const Case scene = picture(5,
                               "mm.pu"
                               "mm.pu"
                               "mvvvf"
                               "....f");
    using Area = studio::MarkedArea;
    const std::vector<Area> expected{{0, 0, 2, 2, Judgement::missed},
                                     {3, 0, 1, 2, Judgement::phantom},
                                     {4, 0, 1, 2, Judgement::excused},
                                     {0, 2, 1, 1, Judgement::missed},
                                     {1, 2, 3, 1, Judgement::moved}};
    EXPECT_EQ(studio::marked_areas(scene.reference, scene.metrics), expected);
}

TEST(MarkedAreas, of_nothing_wrong_are_none) {
    const Case scene = picture(3, ".f..f.");
    EXPECT_TRUE(studio::marked_areas(scene.reference, scene.metrics).empty());
    EXPECT_TRUE(studio::marked_areas({}, {}).empty());
}

TEST(MarkedAreas, cover_each_marked_pixel_once) {
    constexpr unsigned seed = 5;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 200; ++round) {
        const int width = 1 + static_cast<int>(random() % 9);
        std::string text(static_cast<std::size_t>(width) * (1 + random() % 7), '.');
        for (char& letter : text) letter = "mmmpvuf.."[random() % 9];
        const Case scene = picture(width, text);
        std::string painted(text.size(), '.');
        for (const auto& area : studio::marked_areas(scene.reference, scene.metrics)) {
            for (int y = area.y; y < area.y + area.height; ++y) {
                for (int x = area.x; x < area.x + area.width; ++x) {
                    char& letter = painted[static_cast<std::size_t>(y * width + x)];
                    EXPECT_EQ(letter, '.') << "covered twice";
                    letter = "?mpvu"[static_cast<int>(area.judgement)];
                }
            }
        }
        for (char& letter : text) letter = letter == 'f' ? '.' : letter;
        EXPECT_EQ(painted, text);
    }
}

}  // namespace
