// SPDX-License-Identifier: MIT
#include "oracle/reference_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <string>

#include "base/temporary_folder.h"

namespace oracle {
namespace {

Reference small() {
    Reference reference;
    reference.width = 3;
    reference.height = 1;
    reference.pixel_width = 0.1;
    reference.heuristic = true;
    const double infinity = std::numeric_limits<double>::infinity();
    reference.pixels = {
        {Verdict::hit, true, 7, 1.25, 1.25 + 1e-12, {0, -0.6, 0.8}},
        {Verdict::miss, false, -1, infinity, infinity, {0, 0, 0}},
        {Verdict::undecided, false, 0, 2, 3, {1, 0, 0}, true},
    };
    return reference;
}

std::string problem_of(std::string_view bytes) {
    const auto reference = from_bytes(bytes);
    return reference ? "" : reference.problems().front().message;
}

const std::string damaged =
    "the reference is cut off or damaged; make it again with 'zeroset oracle'";
const std::string unknown =
    "this is no reference of this version; make one with 'zeroset oracle --reference'";

TEST(ReferenceFile, keeps_every_number) {
    const auto again = from_bytes(to_bytes(small()));
    ASSERT_TRUE(again);
    EXPECT_EQ(again->width, 3);
    EXPECT_EQ(again->height, 1);
    EXPECT_EQ(again->pixel_width, 0.1);
    EXPECT_TRUE(again->heuristic);
    for (std::size_t i = 0; i < 3; ++i) {
        const Pixel &a = again->pixels[i], b = small().pixels[i];
        EXPECT_EQ(a.verdict, b.verdict);
        EXPECT_EQ(a.fragile, b.fragile);
        EXPECT_EQ(a.object, b.object);
        EXPECT_EQ(a.near, b.near);
        EXPECT_EQ(a.far, b.far);
        EXPECT_EQ(a.normal, b.normal);
        EXPECT_EQ(a.estimated, b.estimated);
    }
    EXPECT_EQ(to_bytes(*again), to_bytes(small()));
}

TEST(ReferenceFile, refuses_every_change_of_a_byte_and_every_cut) {
    const std::string bytes = to_bytes(small());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string changed = bytes;
        changed[i] = static_cast<char>(changed[i] ^ 0x10);
        EXPECT_NE(problem_of(changed), "") << i;
        EXPECT_NE(problem_of(bytes.substr(0, i)), "") << i;
    }
    EXPECT_EQ(problem_of(bytes + "x"), damaged);
    EXPECT_EQ(problem_of("zeroset reference 2 99999 2\n"), damaged);
    EXPECT_EQ(problem_of("zeroset reference 3 3 1\n"), unknown);
    EXPECT_EQ(problem_of("P6 3 1 255\n"), unknown);
}

TEST(ReferenceFile, goes_through_a_file) {
    const TemporaryFolder folder;
    ASSERT_TRUE(write_reference(folder / "a", small()));
    const auto again = read_reference(folder / "a");
    ASSERT_TRUE(again);
    EXPECT_EQ(to_bytes(*again), to_bytes(small()));
    std::ofstream(folder / "b") << "hello";
    EXPECT_EQ(read_reference(folder / "b").problems().front().message,
              "cannot read '" + (folder / "b").string() + "': " + unknown);
}

}  // namespace
}  // namespace oracle
