// SPDX-License-Identifier: MIT
#include "formula/limits.h"

#include <gtest/gtest.h>

#include <string>

#include <fmt/format.h>

#include "formula/understood.h"

namespace formula {
namespace {

std::string repeat(const std::string& piece, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += piece;
    return text;
}

TEST(Limits, a_formula_is_not_longer_than_the_limit) {
    EXPECT_EQ(errors_of("x #" + std::string(max_text_bytes - 3, '.')), "");
    EXPECT_EQ(errors_of("x #" + std::string(max_text_bytes - 2, '.')),
              "1:65537: the formula is longer than 65536 bytes");
}

TEST(Limits, long_flat_formulas_are_fine) {
    EXPECT_EQ(errors_of(repeat("x+", 15000) + "x"), "");
    EXPECT_EQ(errors_of(repeat("x*", 15000) + "x"), "");
    EXPECT_EQ(errors_of(repeat("(x)", 15000)), "");
    EXPECT_EQ(errors_of(repeat("-", 60000) + "x"), "");
    EXPECT_EQ(errors_of(repeat("x|", 9000) + "x"), "");
    EXPECT_EQ(errors_of("min(" + repeat("x,", 15000) + "x)"), "");
    EXPECT_EQ(errors_of("x" + std::string(60000, '\n') + "= 1"), "");
    EXPECT_EQ(tree_of(repeat("-", 60001) + "x"), "negate(x)");
}

TEST(Limits, nested_brackets_of_all_kinds_are_fine_up_to_the_limit) {
    for (const std::string opening : {"(", "-(", "sin(", "2^(", "1+2(", "-x^-(", "max(x,"}) {
        EXPECT_EQ(errors_of(repeat(opening, 200) + "x" + repeat(")", 200)), "") << opening;
    }
    EXPECT_EQ(errors_of(repeat("complement(", 200) + "x <= 0" + repeat(")", 200)), "");
    EXPECT_EQ(errors_of(repeat("x <= 0 | y <= 0 & (", 200) + "x <= 0" + repeat(")", 200)), "");
}

TEST(Limits, high_trees_without_brackets_are_one_error) {
    const std::string message =
        ": the expression nests more than 1000 levels deep; give parts of it names in definitions";
    EXPECT_EQ(errors_of(repeat("x^", 900) + "x"), "");
    const std::string tall = repeat("x^", 30000) + "x";
    EXPECT_EQ(errors_of(tall), "1:" + std::to_string(2 * (30000 - 1000) + 1) + message);
    EXPECT_EQ(errors_of(repeat("x^-", 20000) + "x").substr(0, 2), "1:");
    EXPECT_EQ(errors_of(repeat("x^-x^-x^-x^-(", 200) + "x" + repeat(")", 200)).substr(0, 2), "1:");
}

TEST(Limits, a_graph_has_no_more_nodes_than_the_limit) {
    std::string text = "f(a) = " + repeat("sin(", 15) + "a*x" + repeat(")", 15) + "\n";
    for (int i = 1; i < 8000; ++i) text += "f(" + std::to_string(i) + ")+";
    EXPECT_NE(errors_of(text + "x")
                  .find(": the formula needs more than 100,000 operations; make it shorter"),
              std::string::npos);
    const std::string bulbs = "bulb(i) = translate(mandelbulb(), (i, 0, 0))\nunion(bulb, 9999)";
    EXPECT_NE(errors_of(bulbs).find("the formula needs more than 100,000 operations"),
              std::string::npos);
}

TEST(Limits, doubling_definitions_cannot_exhaust_the_memory) {
    std::string text = "a0 = sphere(1)\n";
    for (int i = 0; i < 60; ++i) {
        const std::string last = "a" + std::to_string(i);
        text += "a" + std::to_string(i + 1) + " = " + last + " | " + last + "\n";
    }
    EXPECT_EQ(errors_of(text + "a60"),
              "15:7: the formula has more than 10,000 objects; make it shorter");
    std::string maps = "a = " + repeat("sphere(1)|", 4000) + "sphere(1)\n";
    EXPECT_EQ(errors_of(maps + repeat("translate(a,0,0,1)|", 1000) + "a").substr(0, 2), "2:");
}

TEST(Limits, doubling_functions_cannot_exhaust_time_or_memory) {
    std::string text = "f0(a) = a + x\n";
    for (int i = 1; i <= 60; ++i) {
        const std::string last = "f" + std::to_string(i - 1);
        text += "f" + std::to_string(i) + "(a) = " + last + "(a) + " + last + "(a)\n";
    }
    EXPECT_EQ(errors_of(text + "f60(1)"),
              "62:1: the formula has more than 200,000 expressions where its functions are put in; "
              "call them less often");
    EXPECT_EQ(errors_of(text + "f8(1)"), "");
}

TEST(Limits, deep_calls_of_functions_are_one_error) {
    const auto deep = [](int calls) {
        std::string text = "f0(a) = a\n";
        for (int i = 1; i <= calls; ++i) {
            text += fmt::format("f{}(a) = -f{}(a)\n", i, i - 1);
        }
        return text + fmt::format("f{}(x)", calls);
    };
    EXPECT_EQ(errors_of(deep(99)), "");
    EXPECT_EQ(errors_of(deep(100)), "102:1: the calls of functions nest more than 100 levels deep");
    EXPECT_EQ(errors_of(deep(3000)),
              "3002:1: the calls of functions nest more than 100 levels deep");
    // High bodies within high bodies.
    std::string text = "f0(a) = a\n";
    for (int i = 1; i <= 6; ++i) {
        text += fmt::format("f{}(a) = {}f{}(a)\n", i, repeat("x^", 600), i - 1);
    }
    EXPECT_EQ(errors_of(text + "f6(x)"),
              "8:1: the bodies of functions nest more than 1500 levels deep");
}

TEST(Limits, numbers_that_are_too_large_are_errors) {
    EXPECT_EQ(errors_of("x + 1e999 + 1e400"),
              "1:5: the number is too large; the largest is about 1.8e308\n"
              "1:13: the number is too large; the largest is about 1.8e308");
    EXPECT_EQ(value_of("1e-999"), 0);
}

TEST(Limits, at_most_some_errors_are_reported) {
    EXPECT_EQ(understand(repeat("foo+", 100) + "x").problems().size(), max_errors);
}

}  // namespace
}  // namespace formula
