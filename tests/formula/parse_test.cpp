// SPDX-License-Identifier: MIT
#include "formula/parse.h"

#include <gtest/gtest.h>

#include "formula/understood.h"

namespace formula {
namespace {

TEST(Parse, an_empty_formula_is_an_error_that_says_what_to_type) {
    const std::string message =
        "1:1: the formula is empty; type an equation such as x^2 + y^2 + z^2 = 1";
    EXPECT_EQ(errors_of(""), message);
    EXPECT_EQ(errors_of("  \n\t\n"), message);
    EXPECT_EQ(errors_of("# nothing\n# here"), message);
}

TEST(Parse, parameters_alone_show_nothing) {
    EXPECT_EQ(errors_of("param a = 1\n"),
              "1:12: the formula has nothing to show; type an equation such as x^2 + y^2 + z^2 = 1 "
              "below its parameters");
}

TEST(Parse, every_statement_is_parsed_on_its_own) {
    EXPECT_EQ(errors_of("a = 1 +\nb = (2 3)\nparam c 1\nx y"),
              "1:8: expected an expression after '+'; a definition ends with its line\n"
              "2:8: no operator between '2' and '3'; write '2*3' for a product\n"
              "3:9: expected '=' after 'c'\n"
              "4:3: no operator between 'x' and 'y'; write 'x*y' for a product");
    EXPECT_EQ(parse("a = 1 +\nb = (2 3)\nx y").problems().size(), 3u);
}

TEST(Parse, keeps_statements_with_errors_as_broken_ones) {
    const Reading reading = read("a = 2 3\nx = a");
    ASSERT_TRUE(reading.program);
    EXPECT_EQ(reading.errors.size(), 1u);
    const auto& definition = std::get<Definition>(reading.program->statements.at(0));
    EXPECT_EQ(definition.name, "a");
    EXPECT_TRUE(std::holds_alternative<Broken>((*reading.program)[definition.value].node));
}

TEST(Parse, looks_no_names_up) { EXPECT_TRUE(parse("a = b(c)\nd(e) = f")); }

TEST(Parse, accepts_line_ends_of_windows) { EXPECT_EQ(errors_of("a = 1\r\nx = a\r\n"), ""); }

}  // namespace
}  // namespace formula
