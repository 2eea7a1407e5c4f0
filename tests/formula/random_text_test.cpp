// SPDX-License-Identifier: MIT
// Feeds the whole library with nonsense and near-sense. What comes back must be a field or errors
// whose places are inside the text, and must not depend on anything but the text.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "formula/limits.h"
#include "formula/understood.h"

namespace formula {
namespace {

constexpr const char* good[] = {
    "x^2 + y^2 + z^2 = 1",
    "param a = 0.5 in [0, 2pi] step 0.1 \"how much\"\nb = (1 + a)z^2 # half\nsin(2x)cos(y) + b = 0",
    "ball = sphere(r = 1.25)\nball & x = 0 | box(1, 0.5, hz = .5) \\ (r <= 2.5e-1)",
    "julia(c = (-0.2, 0.6, 0.2, 0.2), iterations = 8)\n | rotate(menger(3), (1, 1, 0), 30)",
    "smooth_union(translate(torus(), (0, 0, t)), scale(mandelbulb(8), 0.5), k = 0.1)",
    "-2^-x^2 + mix(1, 2, x)/3(x+1)(x-1) - max(x, -y, min(1, z), hypot(x, y, z)) >= 1e-3",
    "ring(R, w = 0.2) = torus(R, w) & (abs(z) <= w/2)\np = (x, 2 y, z)\nring(1) | p.xy.y^2 = p.z",
    "param c = (-0.2, 0.6, 0.2, 0.2) in [-1, 1]\n"
    "iterate q = quaternion(x, y, z, 0), s = 9 for 12 until length(q) > 4:\n"
    "    q = q^2 + c\n    s = min(s, length(q)); colour = s\n",
    "param s = \"a\" in [\"a\", \"b\"] group \"g\"\nparam on = off \"cut\" tooltip \"t\"\n"
    "if(s < 1, 1, 2)x = on",
};

constexpr const char* pieces[] = {"x",          "y",
                                  "z",          "r",
                                  "2",          "1e1",
                                  ".5",         "(",
                                  ")",          "[",
                                  "]",          ",",
                                  "+",          "-",
                                  "*",          "/",
                                  "^",          "=",
                                  "<=",         ">",
                                  "|",          "&",
                                  "\\",         "\n",
                                  " ",          "#",
                                  "\"",         "param ",
                                  "in",         "step",
                                  "a",          "sin(",
                                  "sphere(",    "a = ",
                                  "union(",     "julia(",
                                  "translate(", "iterate q = (x, y, z)",
                                  " for 3",     " until q.x > 2",
                                  ":\n  ",      ";",
                                  "q = q + 1",  "f(a) = ",
                                  ".x",         "\"b\"",
                                  "colour ",    "foo",
                                  "\xC2\xB2",   "\xFF",
                                  "1e999",      "!=",
                                  "\t"};

void check(const std::string& text, unsigned seed) {
    const base::Result<Lowered> result = understand(text);
    const base::Diagnostics problems = result.problems();
    ASSERT_EQ(result ? 0u : 1u, problems.empty() ? 0u : 1u) << "seed " << seed << "\n" << text;
    ASSERT_LE(problems.size(), max_errors);
    for (const base::Diagnostic& it : problems) {
        ASSERT_TRUE(it.span) << it.message;
        ASSERT_LE(it.span->begin, it.span->end) << it.message << "\n" << text;
        ASSERT_LE(it.span->end, text.size()) << it.message << "\n" << text;
        ASSERT_FALSE(base::format(it, "formula", text).empty());
    }
    ASSERT_EQ(problems, understand(text).problems()) << "seed " << seed << "\n" << text;
    const base::Result<Program> program = parse(text);
    ASSERT_TRUE(program || !result) << text;
    ASSERT_TRUE(!program || !print_ast(*program).empty()) << text;
}

TEST(RandomText, of_any_bytes_does_no_harm) {
    constexpr unsigned seed = 20240607;
    std::mt19937 random(seed);
    for (int i = 0; i < 4000; ++i) {
        std::string text(random() % 80, ' ');
        for (char& c : text) c = static_cast<char>(random() % 256);
        check(text, seed);
    }
}

TEST(RandomText, of_printable_characters_does_no_harm) {
    constexpr unsigned seed = 99;
    std::mt19937 random(seed);
    for (int i = 0; i < 4000; ++i) {
        std::string text(random() % 60, ' ');
        for (char& c : text) c = static_cast<char>(32 + random() % 95);
        check(text, seed);
    }
}

TEST(RandomText, of_pieces_of_the_language_does_no_harm) {
    constexpr unsigned seed = 4711;
    std::mt19937 random(seed);
    for (int i = 0; i < 6000; ++i) {
        std::string text;
        for (std::size_t n = random() % 30; n > 0; --n)
            text += pieces[random() % std::size(pieces)];
        check(text, seed);
    }
}

TEST(RandomText, that_is_nearly_good_does_no_harm) {
    constexpr unsigned seed = 31337;
    std::mt19937 random(seed);
    for (int i = 0; i < 6000; ++i) {
        std::string text = good[random() % std::size(good)];
        for (std::size_t n = 1 + random() % 4; n > 0 && !text.empty(); --n) {
            const std::size_t at = random() % text.size();
            switch (random() % 4) {
                case 0:
                    text.erase(at, 1 + random() % 3);
                    break;
                case 1:
                    text.insert(at, pieces[random() % std::size(pieces)]);
                    break;
                case 2:
                    text[at] = static_cast<char>(random() % 128);
                    break;
                case 3:
                    text.insert(at, text.substr(random() % text.size(), random() % 12));
                    break;
            }
        }
        check(text, seed);
    }
}

TEST(RandomText, good_examples_are_good) {
    for (const char* text : good) EXPECT_EQ(errors_of(text), "") << text;
}

}  // namespace
}  // namespace formula
