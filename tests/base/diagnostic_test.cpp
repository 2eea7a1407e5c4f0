// SPDX-License-Identifier: MIT
// The texts that people and editors read: places, excerpts and carets.
#include "base/diagnostic.h"

#include <gtest/gtest.h>

namespace {

using base::SourceSpan;

/// The three lines for an error "wrong" at a span of a text.
std::string shown(const std::string& text, SourceSpan span) {
    return base::format(base::error(span, "wrong"), "formula", text);
}

TEST(Diagnostic, marks_a_span_with_a_caret_and_tildes) {
    const auto problem = base::error({8, 12}, "unknown name 'sine'; did you mean 'sin'?");
    EXPECT_EQ(base::format(problem, "formula", "x + y + sine(z) = 0"),
              "formula:1:9: error: unknown name 'sine'; did you mean 'sin'?\n"
              "x + y + sine(z) = 0\n"
              "        ^~~~\n");
}

TEST(Diagnostic, says_warning_for_a_warning) {
    EXPECT_EQ(base::format(base::warning({0, 1}, "odd"), "a.json", "x"),
              "a.json:1:1: warning: odd\nx\n^\n");
}

TEST(Diagnostic, has_one_line_without_a_place) {
    EXPECT_EQ(base::format(base::error("cannot do it"), "a.json", "x"),
              "a.json: error: cannot do it\n");
}

TEST(Diagnostic, marks_an_empty_span_with_one_caret) {
    EXPECT_EQ(shown("x + ", {2, 2}), "formula:1:3: error: wrong\nx + \n  ^\n");
}

TEST(Diagnostic, keeps_tabs_so_that_the_caret_stands_below) {
    EXPECT_EQ(shown("\tx\t+ foo", {5, 8}), "formula:1:6: error: wrong\n\tx\t+ foo\n\t \t  ^~~\n");
}

TEST(Diagnostic, counts_characters_not_bytes) {
    // a umlaut (two bytes), euro (three), an emoji (four) before the marked x.
    const std::string text = "\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80 x";
    EXPECT_EQ(shown(text, {10, 11}), "formula:1:5: error: wrong\n" + text + "\n    ^\n");
}

TEST(Diagnostic, marks_a_wide_character_once) {
    EXPECT_EQ(shown("\xE2\x82\xAC\xE2\x82\xAC", {0, 6}),
              "formula:1:1: error: wrong\n\xE2\x82\xAC\xE2\x82\xAC\n^~\n");
}

TEST(Diagnostic, shows_the_line_of_the_place) {
    EXPECT_EQ(shown("a = 1\nb = c\nd", {10, 11}), "formula:2:5: error: wrong\nb = c\n    ^\n");
}

TEST(Diagnostic, cuts_a_span_over_several_lines_at_the_end_of_the_first) {
    EXPECT_EQ(shown("first (\nsecond\n)", {6, 16}),
              "formula:1:7: error: wrong\nfirst (\n      ^\n");
    EXPECT_EQ(shown("one two\nthree", {4, 13}), "formula:1:5: error: wrong\none two\n    ^~~\n");
}

TEST(Diagnostic, points_behind_the_last_character_at_the_end_of_the_text) {
    EXPECT_EQ(shown("x +", {3, 3}), "formula:1:4: error: wrong\nx +\n   ^\n");
}

TEST(Diagnostic, points_behind_the_line_at_a_line_break) {
    EXPECT_EQ(shown("x +\ny", {3, 4}), "formula:1:4: error: wrong\nx +\n   ^\n");
}

TEST(Diagnostic, shows_an_empty_last_line) {
    EXPECT_EQ(shown("x +\n", {4, 4}), "formula:2:1: error: wrong\n\n^\n");
}

TEST(Diagnostic, shows_an_empty_text) {
    EXPECT_EQ(shown("", {0, 0}), "formula:1:1: error: wrong\n\n^\n");
}

TEST(Diagnostic, takes_a_place_behind_the_text_as_its_end) {
    EXPECT_EQ(shown("xy", {90, 95}), "formula:1:3: error: wrong\nxy\n  ^\n");
}

TEST(Diagnostic, blanks_a_carriage_return) {
    EXPECT_EQ(shown("x y\r\nz", {2, 3}), "formula:1:3: error: wrong\nx y \n  ^\n");
}

TEST(Diagnostic, cuts_a_long_line_to_a_window_around_the_place) {
    std::string text(5000, 'a');
    text[4000] = 'B';
    const std::string out = shown(text, {4000, 4001});
    const std::size_t line_end = out.find('\n', out.find('\n') + 1);
    const std::size_t line_begin = out.find('\n') + 1;
    EXPECT_EQ(out.substr(0, line_begin), "formula:1:4001: error: wrong\n");
    EXPECT_LE(line_end - line_begin, 160u);
    const std::string line = out.substr(line_begin, line_end - line_begin);
    const std::string marks = out.substr(line_end + 1);
    EXPECT_EQ(line[marks.find('^')], 'B');
}

TEST(Diagnostic, keeps_the_caret_in_place_at_both_ends_of_a_long_line) {
    for (const std::uint32_t place : {0u, 1u, 159u, 160u, 4840u, 4999u}) {
        std::string text(5000, 'a');
        text[place] = 'B';
        const std::string out = shown(text, {place, place + 1});
        const std::size_t line_begin = out.find('\n') + 1;
        const std::size_t line_end = out.find('\n', line_begin);
        const std::size_t caret = out.find('^') - line_end - 1;
        EXPECT_EQ(out[line_begin + caret], 'B') << place;
    }
}

TEST(Diagnostic, counts_lines_and_columns_from_one) {
    const std::string text =
        "a\n\xC3\xA4"
        "b\n";
    EXPECT_EQ(base::line_column(text, 0).line, 1u);
    EXPECT_EQ(base::line_column(text, 0).column, 1u);
    EXPECT_EQ(base::line_column(text, 4).line, 2u);
    EXPECT_EQ(base::line_column(text, 4).column, 2u);
    EXPECT_EQ(base::line_column(text, 6).line, 3u);
    EXPECT_EQ(base::line_column(text, 6).column, 1u);
}

TEST(Diagnostic, finds_errors_among_warnings) {
    EXPECT_FALSE(base::has_errors({}));
    EXPECT_FALSE(base::has_errors({base::warning({}, "odd")}));
    EXPECT_TRUE(base::has_errors({base::warning({}, "odd"), base::error("wrong")}));
}

}  // namespace
