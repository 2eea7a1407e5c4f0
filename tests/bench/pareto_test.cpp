// SPDX-License-Identifier: MIT
#include "bench/pareto.h"

#include <gtest/gtest.h>

#include <array>

namespace bench {
namespace {

using Front = std::vector<bool>;

TEST(ParetoFront, leaves_out_what_is_beaten_in_both) {
    const std::array trades{Trade{1, 100}, Trade{2, 10}, Trade{3, 20}, Trade{4, 0}, Trade{5, 0}};
    EXPECT_EQ(pareto_front(trades), (Front{true, true, false, true, false}));
}

TEST(ParetoFront, keeps_equal_ones) {
    EXPECT_EQ(pareto_front(std::array{Trade{1, 1}, Trade{1, 1}}), (Front{true, true}));
}

TEST(ParetoFront, of_the_same_time_keeps_the_better) {
    EXPECT_EQ(pareto_front(std::array{Trade{1, 2}, Trade{1, 1}}), (Front{false, true}));
}

TEST(ParetoFront, of_one_or_none) {
    EXPECT_EQ(pareto_front(std::array{Trade{9, 9}}), Front{true});
    EXPECT_TRUE(pareto_front({}).empty());
}

}  // namespace
}  // namespace bench
