// SPDX-License-Identifier: MIT
#include "torture/known_failures.h"

#include <gtest/gtest.h>

#include "base/file.h"
#include "base/temporary_folder.h"

namespace torture {
namespace {

TEST(KnownFailures, allow_two_pixels_or_a_twentieth) {
    EXPECT_FALSE(is_worse({2, 0, 0, 0}, {}));
    EXPECT_TRUE(is_worse({3, 0, 0, 0}, {}));
    EXPECT_TRUE(is_worse({0, 3, 0, 0}, {}));
    EXPECT_TRUE(is_worse({0, 0, 3, 0}, {}));
    EXPECT_TRUE(is_worse({0, 0, 0, 3}, {}));
    EXPECT_FALSE(is_worse({105, 0, 0, 0}, {100, 0, 0, 0}));
    EXPECT_TRUE(is_worse({106, 0, 0, 0}, {100, 0, 0, 0}));
}

TEST(KnownFailures, are_better_only_beyond_the_allowance) {
    EXPECT_FALSE(is_better({8, 0, 0, 0}, {10, 0, 0, 0}));
    EXPECT_TRUE(is_better({7, 0, 0, 0}, {10, 0, 0, 0}));
    // Another kind of wrong is no improvement.
    EXPECT_FALSE(is_better({0, 10, 0, 0}, {10, 0, 0, 0}));
}

TEST(KnownFailures, shrink_number_by_number) {
    EXPECT_EQ(shrunk({1, 8, 3, 0}, {4, 5, 3, 2}), (Failures{1, 5, 3, 0}));
}

TEST(KnownFailures, read_back_as_they_were_written) {
    Records records;
    records["a/b"] = {100, 2, 3, {{"auto", {1, 2, 3, 4}}, {"sphere", {}}}};
    records["c"] = {7, 0, 0, {{"auto", {0, 0, 0, 9}}}};
    const TemporaryFolder folder;
    const auto path = folder / "records.json";
    ASSERT_TRUE(base::write_atomically(path, records_text(records)));
    const auto read = read_records(path);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, records);
}

}  // namespace
}  // namespace torture
