// SPDX-License-Identifier: MIT
// Whole pictures: seams, regions, repeats, refusals.
#include "render/still.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "render/small_programs.h"

namespace {

using render::View;
using render_test::everything;
using render_test::text;

template <class Value, int Channels>
image::Image<Value, Channels> crop(const image::Image<Value, Channels>& image, int x, int y,
                                   int width, int height) {
    image::Image<Value, Channels> part(width, height);
    for (int row = 0; row < height; ++row)
        std::copy_n(image.at(x, y + row), width * Channels, part.at(0, row));
    return part;
}

class StillTest : public render_test::WithContext {
protected:
    render::Still draw(const shader::ProgramSource& source, const View& view, int repeat = 0) {
        auto still = render::draw_still(*context, source, {}, render_test::frame_of, view,
                                        everything, repeat);
        EXPECT_TRUE(still) << text(still);
        return still ? std::move(*still) : render::Still();
    }
    std::string refusal(const View& view) {
        return text(render::draw_still(*context, render_test::coordinates(), {},
                                       render_test::frame_of, view, everything));
    }
};

TEST_F(StillTest, pictures_larger_than_a_canvas_have_no_seams) {
    for (const auto& [width, height] : {std::pair(2111, 67), std::pair(45, 2077)}) {
        const render::Still still = draw(render_test::coordinates(), render::whole(width, height));
        ASSERT_EQ(still.picture.width, width);
        ASSERT_EQ(still.geometry.height, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                ASSERT_EQ(still.geometry.at(x, y)[0], static_cast<float>(x));
                ASSERT_EQ(still.geometry.at(x, y)[1], static_cast<float>(y));
                ASSERT_EQ(still.picture.at(x, y)[0], x % 256);
                ASSERT_EQ(still.picture.at(x, y)[1], y % 256);
            }
    }
}

TEST_F(StillTest, a_region_is_the_crop_of_the_whole_bit_by_bit) {
    const int width = 2201;
    const int height = 203;
    const render::Still full = draw(render_test::waves(), render::whole(width, height));
    for (const View& view :
         {View{width, height, 0, 0, 1, 1}, View{width, height, 37, 19, 101, 53},
          View{width, height, 2030, 5, 40, 190}, View{width, height, 1, 0, 2200, 203},
          View{width, height, 2200, 202, 1, 1}}) {
        const render::Still part = draw(render_test::waves(), view);
        const auto same = [&](const auto& whole, const auto& piece) {
            return crop(whole, view.x, view.y, view.region_width, view.region_height) == piece;
        };
        EXPECT_TRUE(same(full.picture, part.picture)) << view.x << "," << view.y;
        EXPECT_TRUE(same(full.geometry, part.geometry)) << view.x << "," << view.y;
        EXPECT_TRUE(same(full.normal, part.normal)) << view.x << "," << view.y;
    }
}

TEST_F(StillTest, the_frame_is_asked_for_each_parts_place) {
    std::vector<View> asked;
    const auto frame_of = [&](const View& view) {
        asked.push_back(view);
        return render_test::frame_of(view);
    };
    const auto still = render::draw_still(*context, render_test::coordinates(), {}, frame_of,
                                          {5000, 900, 100, 200, 2050, 3}, everything);
    ASSERT_TRUE(still) << text(still);
    ASSERT_EQ(asked.size(), 2u);
    EXPECT_EQ(asked[0].width, 5000);
    EXPECT_EQ(asked[1].height, 900);
    EXPECT_EQ(asked[0].x, 100);
    EXPECT_EQ(asked[1].x, 2148);
    EXPECT_EQ(asked[1].y, 200);
    EXPECT_EQ(asked[1].region_width, 2);
    EXPECT_EQ(still->geometry.at(2049, 2)[0], 2149.0f);
    EXPECT_EQ(still->geometry.at(2049, 2)[1], 202.0f);
}

TEST_F(StillTest, each_repeat_reports_a_time_and_draws_the_same) {
    const render::Still once = draw(render_test::waves(), render::whole(300, 150));
    const render::Still often = draw(render_test::waves(), render::whole(300, 150), 3);
    EXPECT_TRUE(once.frame_seconds.empty());
    ASSERT_EQ(often.frame_seconds.size(), 3u);
    for (double seconds : often.frame_seconds) EXPECT_GT(seconds, 0);
    EXPECT_GT(often.first_frame_seconds, 0);
    EXPECT_GT(often.link_seconds, 0);
    EXPECT_EQ(once.geometry, often.geometry);
}

TEST_F(StillTest, only_what_is_asked_for_is_there) {
    const auto still =
        render::draw_still(*context, render_test::coordinates(), {}, render_test::frame_of,
                           render::whole(5, 5), {false, true, false, false});
    ASSERT_TRUE(still) << text(still);
    EXPECT_TRUE(still->picture.values.empty());
    EXPECT_TRUE(still->normal.values.empty());
    EXPECT_EQ(still->geometry.at(4, 3)[0], 4.0f);
}

TEST_F(StillTest, a_program_that_does_not_link_is_an_error) {
    shader::ProgramSource source = render_test::coordinates();
    source.fragment = "#version 450 core\nnonsense";
    const auto still = render::draw_still(*context, source, {}, render_test::frame_of,
                                          render::whole(5, 5), everything);
    ASSERT_FALSE(still);
    EXPECT_TRUE(text(still).starts_with("the OpenGL driver rejects the fragment shader:\n"));
}

TEST_F(StillTest, refuses_empty_pictures_and_regions) {
    EXPECT_EQ(refusal(render::whole(0, 720)),
              "a picture of 0x720 pixels is empty; both sides must be at least 1\n");
    EXPECT_EQ(refusal({100, 100, 10, 10, 5, 0}),
              "a region of 5x0 pixels is empty; both sides must be at least 1\n");
}

TEST_F(StillTest, refuses_sides_above_the_largest) {
    EXPECT_EQ(refusal({40000, 20, 0, 0, 10, 10}),
              "a picture of 40000x20 pixels is too large; neither side may be above 32768\n");
}

TEST_F(StillTest, refuses_more_pixels_than_are_drawn_at_once) {
    EXPECT_EQ(
        refusal(render::whole(32768, 32768)),
        "32768x32768 are 1073741824 pixels, but at most 268435456 are drawn at once; draw the "
        "picture in regions\n");
}

TEST_F(StillTest, draws_a_small_region_of_the_largest_picture) {
    const render::Still still =
        draw(render_test::coordinates(), {32768, 32768, 32760, 32761, 8, 7});
    EXPECT_EQ(still.geometry.at(7, 6)[0], 32767.0f);
    EXPECT_EQ(still.geometry.at(7, 6)[1], 32767.0f);
}

TEST_F(StillTest, refuses_a_region_outside_of_the_picture) {
    EXPECT_EQ(
        refusal({100, 80, 90, 0, 11, 10}),
        "the region 90,0,11,10 (left, top, width, height) reaches out of the picture of 100x80 "
        "pixels\n");
    EXPECT_EQ(
        refusal({100, 80, 0, -1, 10, 10}),
        "the region 0,-1,10,10 (left, top, width, height) reaches out of the picture of 100x80 "
        "pixels\n");
    EXPECT_EQ(refusal({100, 80, 2147483647, 0, 2147483647, 1}),
              "the region 2147483647,0,2147483647,1 (left, top, width, height) reaches out of the "
              "picture of 100x80 pixels\n");
}

}  // namespace
