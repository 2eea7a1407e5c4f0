// SPDX-License-Identifier: MIT
// What is done for a slider's move, without a driver.
#include "bench/slider_move.h"

#include <gtest/gtest.h>

#include <vector>

namespace bench {
namespace {

TEST(SliderMove, hands_over_other_numbers_each_time_and_none_where_nothing_moves) {
    scene::Document document;
    const auto move = [&](const char* text, std::vector<shader::FieldNumbers>& drawn) {
        const auto formula = compile::compile_formula(text);
        const auto source = compile::program_source(*formula, document, {});
        return move_slider(*formula, source, document, [&](shader::FieldNumbers numbers) {
            drawn.push_back(std::move(numbers));
        });
    };
    std::vector<shader::FieldNumbers> drawn;
    const auto found =
        move("param n = on\nparam a = 1 in [0, 2]\nif(n, a, 2a)*x^2 + y^2 = exp(z)", drawn);
    ASSERT_TRUE(found);
    EXPECT_GT(found->before_seconds, 0);
    EXPECT_GE(found->picture_seconds, found->before_seconds);
    ASSERT_GT(drawn.size(), 2u);
    for (std::size_t i = 1; i < drawn.size(); ++i) EXPECT_NE(drawn[i], drawn[i - 1]) << i;
    drawn.clear();
    EXPECT_FALSE(move("param n = on\nif(n, 1, 2)*x^2 + y^2 = 1", drawn));
    EXPECT_FALSE(move("x^2 + y^2 = 1", drawn));
    EXPECT_TRUE(drawn.empty());
}

}  // namespace
}  // namespace bench
