// SPDX-License-Identifier: MIT
// The syntax of parameters.
#include <gtest/gtest.h>

#include "formula/understood.h"

namespace formula {
namespace {

/// The tree of a declaration, above a formula that does not matter.
void check(const std::string& text, const std::string& tree) {
    EXPECT_EQ(program_of(text + "\nx"), tree + ", formula(x)") << "formula: " << text;
}

TEST(ReadParameter, has_a_value_a_range_a_step_and_texts) {
    check("param a = 1", "param a(initial(1))");
    check("param a = 1 in [0, 2pi] step 0.1 \"how far\"",
          "param a(initial(1), range(0, product(* 2, . pi)), step(0.1), label \"how far\")");
    check("param a = 1 group \"g\" \"l\" tooltip \"t\" step 2",
          "param a(initial(1), step(2), label \"l\", group \"g\", tooltip \"t\")");
    check("param a = 1 tooltip \"\"", "param a(initial(1), tooltip \"\")");
}

TEST(ReadParameter, has_one_of_several_types) {
    check("param a = 2 in [1, 9] integer", "param a(type integer, initial(2), range(1, 9))");
    check("param a = 2 logarithmic \"l\"", "param a(type logarithmic, initial(2), label \"l\")");
    check("param a = pi angle", "param a(type angle, initial(pi))");
    check("param a = (1, 0.5, 0) step 0.1 colour",
          "param a(type colour, initial(tuple(1, 0.5, 0)), step(0.1))");
    check("param c = (-0.2, 0.6, 0.2, 0.2) in [-1, 1]",
          "param c(initial(tuple(negate(0.2), 0.6, 0.2, 0.2)), range(negate(1), 1))");
    check("param s = \"b\" in [\"a\", \"b\"] \"l\"",
          "param s(type choice, initial(1), choice \"a\", choice \"b\", label \"l\")");
    check("param cut = on", "param cut(type toggle, initial(1))");
    check("param cut = off \"l\" group \"g\"",
          "param cut(type toggle, initial(0), label \"l\", group \"g\")");
}

TEST(ReadParameter, the_words_are_names_elsewhere) {
    check("param angle = 30 in [0, 360]", "param angle(initial(30), range(0, 360))");
    check("param group = 1 group \"g\"", "param group(initial(1), group \"g\")");
    check("param a = angle angle", "param a(type angle, initial(angle))");
    check("param a = 2 angle", "param a(type angle, initial(2))");
    check("param a = (2) colour", "param a(type colour, initial(2))");
    check("param a = 2 step(3) step 4", "param a(initial(product(* 2, . call step(3))), step(4))");
    check("param a = 2 log(3)", "param a(initial(product(* 2, . call log(3))))");
    check("param a = on + 1", "param a(initial(sum(+ on, + 1)))");
    check("param a = on(1)", "param a(initial(call on(1)))");
    check("param a = 2angles", "param a(initial(product(* 2, . angles)))");
    check("angle = 2\ncolour = 3 angle\nparam = colour",
          "define angle(2), define colour(product(* 3, . angle)), define param(colour)");
}

void check_error(const std::string& text, const std::string& errors) {
    EXPECT_EQ(syntax_errors_of(text + "\nx"), errors) << "formula: " << text;
}

TEST(ReadParameter, says_how_a_choice_is_written) {
    check_error("param a = \"b\"",
                "1:14: expected the choices after \"b\"; write 'in [\"b\", \"...\"]'");
    check_error("param a = \"b\" \"label\"",
                "1:15: expected the choices after \"b\"; write 'in [\"b\", \"...\"]'");
    check_error("param a = \"b\" in \"b\", \"c\"", "1:18: expected '[' after 'in'");
    check_error("param a = \"b\" in [1, 2]", "1:19: expected a text in quotes after '['");
    check_error("param a = \"b\" in [\"b\" \"c\"]", "1:23: expected ']' after '\"b\"'");
    check_error("param a = \"b\" in [\"b\", ]", "1:24: expected a text in quotes after ','");
    check_error("param a = \"b\" in [\"b\", \"b\"]", "1:24: the choice \"b\" is there twice");
    check_error("param a = \"rond\" in [\"round\", \"square\"]",
                "1:11: \"rond\" is none of the choices; did you mean \"round\"?");
    check_error("param a = \"c\" in [\"round\", \"square\"]", "1:11: \"c\" is none of the choices");
    check_error("param a = 1 in [\"b\", \"c\"]",
                "1:17: these are choices, so the value is one of them in quotes");
    check_error("param a = \"b\" in [\"b\", \"c\"] step 1",
                "1:29: a parameter that is a choice, on or off has no step");
    check_error("param a = \"b\" in [\"b\", \"c\"] integer",
                "1:29: a parameter that is a choice, on or off cannot be 'integer' too");
}

TEST(ReadParameter, says_what_a_toggle_lacks) {
    check_error("param a = on in [0, 1]", "1:14: a parameter that is on or off has no range");
    check_error("param a = on step 1", "1:14: a parameter that is a choice, on or off has no step");
    check_error("param a = off angle",
                "1:15: a parameter that is a choice, on or off cannot be 'angle' too");
}

TEST(ReadParameter, has_each_modifier_once) {
    check_error("param a = 1 step 1 step 2", "1:20: the parameter has a step already");
    check_error("param a = 1 \"b\" \"c\"", "1:17: the parameter has a label already");
    check_error("param a = 1 group \"b\" group \"c\"", "1:23: the parameter has a group already");
    check_error("param a = 1 tooltip \"b\" tooltip \"c\"",
                "1:25: the parameter has a tooltip already");
    check_error("param a = 1 angle integer",
                "1:19: 'integer' is the second type; a parameter has only one");
    check_error("param a = 1 in [0, 2] in [0, 3]",
                "1:23: 'in' is out of place; the range stands next to the value");
    check_error("param a = 1 = 2",
                "1:13: unexpected '='; a parameter is written 'param a = 0.5 in [0, 2] step 0.1 "
                "\"label\"'");
}

TEST(ReadParameter, says_which_word_was_meant) {
    check_error("param a = 1 intger",
                "1:13: unknown word 'intger' behind the value; did you mean 'integer'?");
    check_error("param a = 1 color",
                "1:13: unknown word 'color' behind the value; did you mean 'colour'?");
    check_error("param a = pi angles",
                "1:14: unknown word 'angles' behind the value; did you mean 'angle'?");
    check_error("param a = 1 integer foo",
                "1:21: unknown word 'foo' behind the value; it is one of angle, colour, group, in, "
                "integer, logarithmic, step, tooltip");
    check_error("param a = 1 in [0, 2] 3",
                "1:23: unknown word '3' behind the value; it is one of angle, colour, group, in, "
                "integer, logarithmic, step, tooltip");
    check_error("param a = 1 group", "1:18: expected a text in quotes after 'group'");
    check_error("param a = 1 tooltip step 2", "1:21: expected a text in quotes after 'tooltip'");
    check_error("param a = 1, 2",
                "1:12: a ',' stands only in brackets; write a vector as '(1, 2, 3)'");
}

}  // namespace
}  // namespace formula
