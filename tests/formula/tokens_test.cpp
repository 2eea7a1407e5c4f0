// SPDX-License-Identifier: MIT
#include "formula/tokens.h"

#include <gtest/gtest.h>

#include <string>

#include "formula/understood.h"

namespace formula {
namespace {

/// The tokens, with `/` in front of those that start a line.
std::string tokens_of(std::string_view text) {
    std::string list;
    for (const Token& token : tokenize(text)) {
        if (!list.empty()) list += ' ';
        if (token.starts_line) list += '/';
        list += token.text(text);
    }
    return list;
}

TEST(Tokens, are_words_numbers_and_signs) {
    EXPECT_EQ(tokens_of("2ex<=a_1>= .5e1"), "/2 ex <= a_1 >= .5e1");
    EXPECT_EQ(tokens_of("x2(1.)"), "/x2 ( 1. )");
}

TEST(Tokens, leave_out_blanks_and_comments) {
    EXPECT_EQ(tokens_of("x # y\r\n  # z\n\ty#"), "/x /y");
    EXPECT_EQ(tokens_of(" # x"), "");
}

TEST(Tokens, keep_labels_whole) { EXPECT_EQ(tokens_of("a \"b # (c\" d"), "/a \"b # (c\" d"); }

TEST(Tokens, signs_of_other_languages_get_a_hint) {
    EXPECT_EQ(errors_of("x == 1"), "1:3: unknown operator '=='; write '='");
    EXPECT_EQ(errors_of("x**2 = 1"), "1:2: unknown operator '**'; write '^' for a power");
    EXPECT_EQ(errors_of("x || y"),
              "1:3: unknown operator '||'; write '|' for a union, or abs(x) for an absolute value");
    EXPECT_EQ(errors_of("x && y"), "1:3: unknown operator '&&'; write '&' for an intersection");
    EXPECT_EQ(errors_of("x =< y"), "1:3: unknown operator '=<'; write '<='");
    EXPECT_EQ(errors_of("x => y"), "1:3: unknown operator '=>'; write '>='");
    EXPECT_EQ(errors_of("x =<= y"), "1:3: unknown operator '=<='; write '<='");
    EXPECT_EQ(errors_of("x =>= y"), "1:3: unknown operator '=>='; write '>='");
    EXPECT_EQ(errors_of("x <== y"), "1:3: unknown operator '<=='; write '<='");
    EXPECT_EQ(errors_of("x >== y"), "1:3: unknown operator '>=='; write '>='");
    EXPECT_EQ(errors_of("x << y"), "1:3: unknown operator '<<'; write '<'");
    EXPECT_EQ(errors_of("x >> y"), "1:3: unknown operator '>>'; write '>'");
    EXPECT_EQ(errors_of("x <> y"), "1:3: unknown operator '<>'; compare with '=', '<=' or '>='");
    EXPECT_EQ(errors_of("x // y"),
              "1:3: unknown operator '//'; write '/' for a quotient, or '#' for a comment");
    EXPECT_EQ(errors_of("x \\\\ y"), "1:3: unknown operator '\\\\'; write '\\' for a difference");
    EXPECT_EQ(errors_of("x == 1 && y**2 == 3"),
              "1:3: unknown operator '=='; write '='\n"
              "1:8: unknown operator '&&'; write '&' for an intersection\n"
              "1:12: unknown operator '**'; write '^' for a power\n"
              "1:16: unknown operator '=='; write '='");
}

TEST(Tokens, a_bracket_without_a_partner_is_an_error_at_its_place) {
    EXPECT_EQ(errors_of("(x + 1"), "1:1: this '(' is never closed");
    EXPECT_EQ(errors_of("a = sin(x\nb = 2\na + b"), "1:8: this '(' is never closed");
    EXPECT_EQ(errors_of("(x + (y)"), "1:1: this '(' is never closed");
    EXPECT_EQ(errors_of("x + 1)"), "1:6: no bracket is open that this ')' could close");
    EXPECT_EQ(errors_of(")"), "1:1: no bracket is open that this ')' could close");
    EXPECT_EQ(errors_of("(x]"), "1:3: ']' cannot close a '('; write ')'");
    EXPECT_EQ(errors_of("param a = 1 in [0, 2)\na"), "1:21: ')' cannot close a '['; write ']'");
}

TEST(Tokens, a_label_must_be_closed_on_its_line) {
    EXPECT_EQ(errors_of("param a = 1 \"size\nx = a"),
              "1:13: the label is not closed; write '\"' at its end");
    EXPECT_EQ(errors_of("x = \""), "1:5: the label is not closed; write '\"' at its end");
}

TEST(Tokens, too_many_open_brackets_are_one_error_at_the_first_too_many) {
    const std::string message =
        ": more than 200 brackets are open here; give parts of the formula names in definitions";
    EXPECT_EQ(errors_of(std::string(10000, '(') + "x" + std::string(10000, ')')),
              "1:201" + message);
    EXPECT_EQ(errors_of(std::string(201, '(') + "x" + std::string(201, ')')), "1:201" + message);
    EXPECT_EQ(errors_of(std::string(200, '(') + "x" + std::string(200, ')')), "");
}

}  // namespace
}  // namespace formula
