// SPDX-License-Identifier: MIT
#include "formula/statements.h"

#include <gtest/gtest.h>

#include <string>

namespace formula {
namespace {

/// Each statement as `kind: text`, separated by bars.
std::string statements_of(std::string_view text) {
    const std::vector<Token> tokens = tokenize(text);
    std::string list;
    for (const StatementText& it : split(text, tokens)) {
        if (!list.empty()) list += " | ";
        switch (it.kind) {
            case StatementText::Kind::definition:
                list += "define: ";
                break;
            case StatementText::Kind::parameter:
                list += "param: ";
                break;
            case StatementText::Kind::result:
                list += "result: ";
                break;
            case StatementText::Kind::iteration_head:
            case StatementText::Kind::assignment:
                list += "no statement: ";
                break;
        }
        list += text.substr(it.span().begin, it.span().end - it.span().begin);
    }
    return list;
}

TEST(Statements, a_line_with_an_equals_sign_is_a_definition_if_anything_follows) {
    EXPECT_EQ(statements_of("a = 1\na + x"), "define: a = 1 | result: a + x");
    EXPECT_EQ(statements_of("a = 1\n\n  # end\n"), "result: a = 1");
    EXPECT_EQ(statements_of("r = 0.5"), "result: r = 0.5");
    EXPECT_EQ(statements_of("a=1\nb=2\nx=a"), "define: a=1 | define: b=2 | result: x=a");
}

TEST(Statements, the_result_takes_the_rest_of_the_text) {
    EXPECT_EQ(statements_of("x^2\n+ y^2\n= 1"), "result: x^2\n+ y^2\n= 1");
    EXPECT_EQ(statements_of("x +\ny = 1"), "result: x +\ny = 1");
    EXPECT_EQ(statements_of("x\na = 1\nb"), "result: x\na = 1\nb");
}

TEST(Statements, a_line_goes_on_while_a_bracket_is_open) {
    EXPECT_EQ(statements_of("a = (1 +\n2)\nx"), "define: a = (1 +\n2) | result: x");
    EXPECT_EQ(statements_of("param a = 1 in [0,\n2]\nx"),
              "param: param a = 1 in [0,\n2] | result: x");
    EXPECT_EQ(statements_of("union(\n  a = 1,\n  b)"), "result: union(\n  a = 1,\n  b)");
}

TEST(Statements, param_is_a_word_only_in_front_of_a_declaration) {
    EXPECT_EQ(statements_of("param a = 1\nx"), "param: param a = 1 | result: x");
    EXPECT_EQ(statements_of("param = 1\nx"), "define: param = 1 | result: x");
    EXPECT_EQ(statements_of("param * x"), "result: param * x");
    EXPECT_EQ(statements_of("param\nx"), "param: param | result: x");
    EXPECT_EQ(statements_of("parameter = 1\nx"), "define: parameter = 1 | result: x");
}

TEST(Statements, comments_and_carriage_returns_do_not_count) {
    EXPECT_EQ(statements_of("# a = 1\r\na = 2 # b = 3\r\nx\r\n"), "define: a = 2 | result: x");
    EXPECT_EQ(statements_of("# only\n"), "");
}

}  // namespace
}  // namespace formula
