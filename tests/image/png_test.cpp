// SPDX-License-Identifier: MIT
// Pictures to PNG files and back, and files that are none.
#include "image/png.h"

#include <random>

#include <gtest/gtest.h>

#include "base/file.h"
#include "base/temporary_folder.h"

namespace {

template <class T>
std::string problem(const base::Result<T>& result) {
    return result ? "no problem" : result.problems().at(0).message;
}

TEST(Png, comes_back_byte_by_byte) {
    const TemporaryFolder folder;
    for (unsigned seed = 0; seed < 5; ++seed) {
        std::mt19937 random(seed);
        image::Picture picture(1 + int(random() % 70), 1 + int(random() % 50));
        for (auto& value : picture.values) value = static_cast<std::uint8_t>(random());
        ASSERT_TRUE(image::write_png(folder / "a.png", picture));
        const auto back = image::read_png(folder / "a.png");
        ASSERT_TRUE(back) << problem(back) << ", seed " << seed;
        EXPECT_EQ(*back, picture) << "seed " << seed;
    }
}

TEST(Png, has_the_top_row_first_and_red_first) {
    const TemporaryFolder folder;
    image::Picture picture(1, 2);
    picture.values = {255, 0, 0, 0, 0, 255};
    ASSERT_TRUE(image::write_png(folder / "a.png", picture));
    const auto bytes = base::read_text(folder / "a.png", 1 << 20);
    ASSERT_TRUE(bytes);
    EXPECT_EQ(bytes->substr(0, 8), "\x89PNG\r\n\x1A\n");
    // IHDR: width 1, height 2, 8 bits, RGB, not interlaced.
    EXPECT_EQ(bytes->substr(16, 13), std::string("\0\0\0\1\0\0\0\2\x08\x02\0\0\0", 13));
    EXPECT_EQ(image::read_png(folder / "a.png")->values, picture.values);
}

TEST(Png, is_the_same_file_for_the_same_picture) {
    const TemporaryFolder folder;
    const image::Picture picture(20, 10);
    ASSERT_TRUE(image::write_png(folder / "a.png", picture));
    ASSERT_TRUE(image::write_png(folder / "b.png", picture));
    EXPECT_EQ(*base::read_text(folder / "a.png", 1 << 20),
              *base::read_text(folder / "b.png", 1 << 20));
}

TEST(Png, with_transparency_is_read_without_it) {
    // One pixel (10, 20, 30) of which the alpha is 0.
    const unsigned char bytes[] = {
        0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48,
        0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x06, 0x00, 0x00,
        0x00, 0x1F, 0x15, 0xC4, 0x89, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x44, 0x41, 0x54, 0x78,
        0x9C, 0x63, 0xE0, 0x12, 0x91, 0x63, 0x00, 0x00, 0x00, 0xA5, 0x00, 0x3D, 0x69, 0x98,
        0x88, 0xBC, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82,
    };
    const TemporaryFolder folder;
    ASSERT_TRUE(base::write_atomically(
        folder / "a.png", std::string(reinterpret_cast<const char*>(bytes), sizeof bytes)));
    const auto picture = image::read_png(folder / "a.png");
    ASSERT_TRUE(picture) << problem(picture);
    EXPECT_EQ(picture->values, (std::vector<std::uint8_t>{10, 20, 30}));
}

TEST(Png, without_pixels_is_an_error) {
    EXPECT_EQ(problem(image::write_png("a.png", image::Picture())),
              "cannot write 'a.png': the picture has no pixels");
}

TEST(Png, that_is_something_else_or_cut_off_is_an_error) {
    const TemporaryFolder folder;
    const auto path = folder / "a.png";
    ASSERT_TRUE(base::write_atomically(path, "no picture"));
    EXPECT_TRUE(problem(image::read_png(path))
                    .starts_with("cannot read '" + path.string() + "': it is not a PNG file"));
    ASSERT_TRUE(image::write_png(path, image::Picture(50, 50)));
    const std::string whole = *base::read_text(path, 1 << 20);
    ASSERT_TRUE(base::write_atomically(path, whole.substr(0, whole.size() / 2)));
    EXPECT_FALSE(image::read_png(path));
}

TEST(Png, says_why_it_cannot_be_written) {
    const TemporaryFolder folder;
    EXPECT_EQ(problem(image::write_png(folder.path(), image::Picture(1, 1))),
              "cannot write '" + folder.path().string() + "': it is a directory; name a file");
}

}  // namespace
