// SPDX-License-Identifier: MIT
// The bytes of PFM files: what other programs read.
#include "image/pfm.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "base/file.h"
#include "base/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
    const base::Result<std::string> bytes = base::read_text(path, 1 << 20);
    return bytes ? *bytes : "unreadable";
}

image::Grey ramp(int width, int height) {
    image::Grey grey(width, height);
    for (std::size_t i = 0; i < grey.values.size(); ++i) grey.values[i] = static_cast<float>(i);
    return grey;
}

template <class T>
std::string problem(const base::Result<T>& result) {
    return result ? "no problem" : result.problems().at(0).message;
}

TEST(Pfm, stores_rows_from_the_bottom_to_the_top_in_little_endian) {
    const TemporaryFolder folder;
    image::Grey grey(2, 2);
    grey.values = {1, 2, 3, 4};
    ASSERT_TRUE(image::write_pfm(folder / "a.pfm", grey));
    const std::string floats("\0\0\x40\x40\0\0\x80\x40\0\0\x80\x3F\0\0\0\x40", 16);  // 3 4 1 2
    EXPECT_EQ(bytes_of(folder / "a.pfm"), "Pf\n2 2\n-1.0\n" + floats);
}

TEST(Pfm, stores_three_channels_of_a_pixel_together) {
    const TemporaryFolder folder;
    image::Vectors vectors(1, 2);
    vectors.values = {0, 0, 0, 1, 2, 4};
    ASSERT_TRUE(image::write_pfm(folder / "a.pfm", vectors));
    const std::string below("\0\0\x80\x3F\0\0\0\x40\0\0\x80\x40", 12);
    EXPECT_EQ(bytes_of(folder / "a.pfm"), "PF\n1 2\n-1.0\n" + below + std::string(12, '\0'));
}

TEST(Pfm, comes_back_with_infinities_and_nan) {
    const TemporaryFolder folder;
    image::Grey grey = ramp(5, 3);
    grey.values[0] = std::numeric_limits<float>::infinity();
    grey.values[1] = -0.0F;
    grey.values[2] = std::numeric_limits<float>::quiet_NaN();
    grey.values[3] = std::numeric_limits<float>::denorm_min();
    ASSERT_TRUE(image::write_pfm(folder / "a.pfm", grey));
    const auto back = image::read_pfm_grey(folder / "a.pfm");
    ASSERT_TRUE(back) << problem(back);
    ASSERT_EQ(back->width, 5);
    ASSERT_EQ(back->height, 3);
    EXPECT_EQ(std::memcmp(back->values.data(), grey.values.data(), 15 * sizeof(float)), 0);
}

TEST(Pfm, of_vectors_comes_back) {
    const TemporaryFolder folder;
    image::Vectors vectors(4, 3);
    for (std::size_t i = 0; i < vectors.values.size(); ++i) vectors.values[i] = 0.1F * float(i);
    ASSERT_TRUE(image::write_pfm(folder / "a.pfm", vectors));
    const auto back = image::read_pfm_vectors(folder / "a.pfm");
    ASSERT_TRUE(back) << problem(back);
    EXPECT_EQ(*back, vectors);
}

TEST(Pfm, in_big_endian_is_read_too) {
    const TemporaryFolder folder;
    ASSERT_TRUE(
        base::write_atomically(folder / "a.pfm", std::string("Pf\n1 1\n1.0\n\x40\x40\0\0", 15)));
    const auto back = image::read_pfm_grey(folder / "a.pfm");
    ASSERT_TRUE(back) << problem(back);
    EXPECT_EQ(back->values, std::vector<float>{3});
}

TEST(Pfm, that_is_cut_off_or_something_else_is_an_error) {
    const TemporaryFolder folder;
    const fs::path path = folder / "a.pfm";
    const std::string start = "cannot read '" + path.string() + "': ";
    ASSERT_TRUE(image::write_pfm(path, ramp(4, 4)));
    const std::string whole = bytes_of(path);
    EXPECT_EQ(problem(image::read_pfm_vectors(path)), start + "it is a grey PFM, not a colour one");
    ASSERT_TRUE(base::write_atomically(path, whole.substr(0, whole.size() - 1)));
    EXPECT_EQ(problem(image::read_pfm_grey(path)),
              start + "it ends in the middle of the picture; it may have been cut off");
    for (const char* text : {"", "Pf", "P6\n1 1\n255\nabc", "Pf\n-1 1\n-1.0\n", "Pf\n0 1\n-1.0\n",
                             "Pf\n1 1\n0\n", "Pf\n1 1\nnan\n", "Pf\n999999999 999999999\n-1.0\n"}) {
        ASSERT_TRUE(base::write_atomically(path, text));
        EXPECT_EQ(problem(image::read_pfm_grey(path)), start + "it is not a PFM file") << text;
    }
}

TEST(Pfm, says_why_it_cannot_be_written) {
    const TemporaryFolder folder;
    const std::string inner = (folder / "no").string();
    EXPECT_EQ(problem(image::write_pfm(folder / "no" / "a.pfm", ramp(1, 1))),
              "cannot write '" + inner + "/a.pfm': the folder '" + inner +
                  "' does not exist; create it or choose another");
}

}  // namespace
