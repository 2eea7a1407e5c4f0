// SPDX-License-Identifier: MIT
#include "formula/characters.h"

#include <gtest/gtest.h>

#include <string>

#include "formula/limits.h"
#include "formula/understood.h"

namespace formula {
namespace {

TEST(Characters, accepts_all_signs_of_the_language) {
    EXPECT_TRUE(check_characters("azAZ09_ \t\r\n.+-*/^()[],=<>&|\\#\"").empty());
}

TEST(Characters, says_which_ascii_sign_to_write) {
    EXPECT_EQ(errors_of("x × y"), "1:3: '×' is not a sign of the language; write '*'");
    EXPECT_EQ(errors_of("x·y"), "1:2: '·' is not a sign of the language; write '*'");
    EXPECT_EQ(errors_of("x − y"), "1:3: '−' is not a sign of the language; write '-'");
    EXPECT_EQ(errors_of("x² = 1"), "1:2: '²' is not a sign of the language; write '^2'");
    EXPECT_EQ(errors_of("x ≤ 1"), "1:3: '≤' is not a sign of the language; write '<='");
    EXPECT_EQ(errors_of("π x"), "1:1: 'π' is not a sign of the language; write 'pi'");
    EXPECT_EQ(errors_of("5 % 2"), "1:3: '%' is not a sign of the language; write 'mod(a, b)'");
    EXPECT_EQ(errors_of("{x}"),
              "1:1: '{' is not a sign of the language; write '('\n"
              "1:3: '}' is not a sign of the language; write ')'");
    EXPECT_EQ(errors_of("x != 1"), "1:3: there is no '!='; compare with '=', '<=' or '>='");
    EXPECT_EQ(errors_of("x ! 1"),
              "1:3: '!' is not a sign of the language; "
              "write a comparison with '=', '<=' or '>='");
    EXPECT_EQ(errors_of("x' = 1"), "1:2: ''' is not a sign of the language; write no quote");
    EXPECT_EQ(errors_of("x @ 1"), "1:3: '@' is not a sign of the language");
    EXPECT_EQ(errors_of("größe = 1"),
              "1:3: 'ö' cannot be used; names are made of the letters a to z, digits and '_'\n"
              "1:4: 'ß' cannot be used; names are made of the letters a to z, digits and '_'");
}

TEST(Characters, counts_columns_in_characters) {
    EXPECT_EQ(errors_of("x = 1 # é\ny²"), "2:2: '²' is not a sign of the language; write '^2'");
    EXPECT_EQ(errors_of("²²"),
              "1:1: '²' is not a sign of the language; write '^2'\n"
              "1:2: '²' is not a sign of the language; write '^2'");
}

TEST(Characters, are_free_in_comments_and_labels) {
    EXPECT_EQ(errors_of("param a = 1 \"größe # { ² %\" # ≤ \" '\nx = a"), "");
}

TEST(Characters, refuses_control_characters_everywhere) {
    using namespace std::string_literals;
    EXPECT_EQ(errors_of("x\0 = 1"s), "1:2: the control character U+0000 cannot be used; delete it");
    EXPECT_EQ(errors_of("x # \x1b[0m"),
              "1:5: the control character U+001B cannot be used; delete it");
    EXPECT_EQ(errors_of("x \x7f"), "1:3: the control character U+007F cannot be used; delete it");
    EXPECT_EQ(errors_of("x \u0085"), "1:3: the control character U+0085 cannot be used; delete it");
}

TEST(Characters, refuses_bytes_that_are_not_utf8) {
    for (const std::string bad :
         {"\xFF", "\xC3", "\x80", "\xC0\xAF", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80",
          "\xF5\x80\x80\x80", "\xC3("}) {
        const base::Diagnostics errors = check_characters("# " + bad);
        ASSERT_FALSE(errors.empty());
        EXPECT_EQ(errors[0].message, "this byte is not valid UTF-8");
        EXPECT_EQ(errors[0].span, (base::SourceSpan{2, 3}));
    }
    EXPECT_TRUE(check_characters("# \xF0\x9F\x98\x80").empty());
}

TEST(Characters, stops_after_some_errors) {
    EXPECT_EQ(check_characters(std::string(1000, '@')).size(), max_errors);
}

}  // namespace
}  // namespace formula
