// SPDX-License-Identifier: MIT
// The time from text to GLSL grows with the length of the formula, and not with its square. Prints
// the curve; only ratios within one run are checked.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include <fmt/format.h>

#include "compile/compile.h"

namespace {

using Writer = std::string (*)(int operations);

/// Numbers that differ, the same in each run.
int spread(int i) { return (i * 7919) % 997 + 1; }

std::string repeated(int operations, const char* between, std::string (*part)(int)) {
    std::string text;
    for (int i = 0; 7 * i < operations; ++i) text += (i == 0 ? "" : between) + part(i);
    return text;
}

std::string waves(int operations) {
    return repeated(operations, " + ",
                    [](int i) {
                        return fmt::format("sin({}x + y*{})*cos(z - {})", spread(i), spread(3 * i),
                                           spread(5 * i));
                    }) +
           " = 0";
}
std::string polynomial(int operations) {
    return repeated(operations, " + ",
                    [](int i) {
                        return fmt::format("{}x^{}*y^{}*z^{}", spread(i), i % 9 + 1, i / 9 % 9 + 1,
                                           i / 81 % 9 + 1);
                    }) +
           " = 0";
}
std::string solids(int operations) {
    return repeated(operations, " | ", [](int i) {
        return fmt::format("((x - .{})^4 + (y - .{})^2 <= .{})", spread(i), spread(3 * i),
                           spread(5 * i));
    });
}

/// The least processor time of several runs, in seconds.
double seconds(const std::string& text) {
    double least = INFINITY;
    for (int run = 0; run < 4; ++run) {
        const std::clock_t start = std::clock();
        const auto formula = compile::compile_formula(text);
        EXPECT_TRUE(formula);
        if (!formula) return least;
        EXPECT_FALSE(compile::program_source(*formula, {}, {}).fragment.empty());
        least = std::min(least, double(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return least;
}

TEST(CompileTime, grows_with_the_length_of_the_formula) {
    for (const auto& [name, writer] : {std::pair<const char*, Writer>{"waves", waves},
                                       {"polynomial", polynomial},
                                       {"solids", solids}}) {
        constexpr int small = 1000, large = 8000;
        const double before = seconds(writer(small)), after = seconds(writer(large));
        fmt::print("{}: {} operations {:.1f} ms, {} operations {:.1f} ms\n", name, small,
                   1e3 * before, large, 1e3 * after);
        // n log n is 1.14 here, the square 2; pages and caches take their part.
        const double exponent = std::log(after / before) / std::log(double(large) / small);
        EXPECT_LT(exponent, 1.6) << name;
    }
}

}  // namespace
