// SPDX-License-Identifier: MIT
#include "formula/explain.h"

#include <gtest/gtest.h>

#include "formula/understood.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view errors) {
    EXPECT_EQ(errors_of(text), errors) << "formula: " << text;
}

TEST(Explain, says_where_an_expression_is_missing) {
    check("x +", "1:4: expected an expression after '+'");
    check("x + # more", "1:4: expected an expression after '+'");
    check("x + * y", "1:5: expected an expression after '+'");
    check("* y", "1:1: expected an expression before '*'");
    check("x -\n)", "2:1: no bracket is open that this ')' could close");
    check("x = ", "1:4: expected an expression after '='");
    check("x = -", "1:6: expected an expression after '-'");
    check("x^", "1:3: expected an expression after '^'");
    check("()", "1:2: expected an expression after '('");
    check("f(1,)", "1:5: expected an expression after ','");
    check("f(,1)", "1:3: expected an expression after '('");
    check("f(*x)", "1:3: expected an expression after '('");
    check("sphere(1) &", "1:12: expected an expression after '&'");
    check("a = 1 +\n2\nx",
          "1:8: expected an expression after '+'; a definition ends with its line\n"
          "3:1: no operator between '2' and 'x'; a product does not cross the end of "
          "a line, write '*'");
    check(".", "1:1: expected an expression before '.'");
}

TEST(Explain, points_from_bars_to_abs) {
    check("|x| = 1",
          "1:1: expected an expression before '|'; '|' is a union, write abs(x) for an "
          "absolute value");
    check("2 + |x| = 1",
          "1:5: expected an expression after '+'; '|' is a union, write abs(x) for an "
          "absolute value");
    check("2|x| = 1",
          "1:6: expected an expression after '|'; '|' is a union, write abs(x) for an "
          "absolute value");
}

TEST(Explain, asks_for_a_sign_between_two_operands) {
    check("x y = 1", "1:3: no operator between 'x' and 'y'; write 'x*y' for a product");
    check("x 2", "1:3: no operator between 'x' and '2'; write 'x*2' for a product");
    check("2 3", "1:3: no operator between '2' and '3'; write '2*3' for a product");
    check("1.2.3", "1:4: no operator between '1.2' and '.3'; write '1.2*.3' for a product");
    check("(x y)", "1:4: no operator between 'x' and 'y'; write 'x*y' for a product");
    check("2x y", "1:4: no operator between 'x' and 'y'; write 'x*y' for a product");
}

TEST(Explain, asks_for_brackets_after_a_function) {
    check("sin x", "1:5: 'sin' needs its argument in brackets; write 'sin(x)'");
    check("1 + sin 2x", "1:9: 'sin' needs its argument in brackets; write 'sin(2x)'");
    check("sphere 2", "1:8: 'sphere' needs its argument in brackets; write 'sphere(2)'");
}

TEST(Explain, refuses_chains_of_comparisons) {
    check("x = y = 1", "1:7: comparisons cannot be chained; join two with '&'");
    check("0 < x < 1", "1:7: comparisons cannot be chained; join two with '&'");
    check("(0 < x <= 1) & y < 2", "1:8: comparisons cannot be chained; join two with '&'");
}

TEST(Explain, tells_what_follows_the_last_expression_to_move_up) {
    check("x + y = 1\na = 2",
          "2:1: the expression has ended above; move the definition of 'a' up, or "
          "join two fields with '|' or '&'");
    check("x + y = 1\nparam a = 2", "2:1: the expression has ended above; move the parameter up");
}

TEST(Explain, names_signs_that_stand_at_a_wrong_place) {
    check("x, y", "1:2: a ',' stands only between arguments in brackets");
    check("x [1]", "1:3: '[' stands only before the range of a parameter; write '('");
    check("[x]", "1:1: expected an expression before '['");
    check("x \"label\"", "1:3: a label stands only at the end of a parameter's line");
    check("a = \"b\"\nx", "1:5: expected an expression after '='");
}

TEST(Explain, says_how_a_parameter_is_written) {
    check("param\nx", "1:6: expected a name after 'param'");
    check("param 3 = 1\nx", "1:7: expected a name after 'param'");
    check("param in = 1\nx", "1:7: expected a name after 'param'");
    check("param a\nx", "1:8: expected '=' after 'a'");
    check("param a 1\nx", "1:9: expected '=' after 'a'");
    check("param a =\nx", "1:10: expected an expression after '='");
    check("param a = 1 [0, 2]\nx",
          "1:13: expected 'in' before the range; write 'in [minimum, maximum]'");
    check("param a = 1 in 0\nx", "1:16: expected '[' after 'in'");
    check("param a = 1 in [0]\nx", "1:18: expected ',' after '0'");
    check("param a = 1 in [0, 1, 2]\nx", "1:21: expected ']' after '1'");
    check("param a = 1 in [0, 2] step\nx", "1:27: expected an expression after 'step'");
    check("param a = 1 step 0.1 in [0, 2]\nx",
          "1:22: 'in' is out of place; the range stands next to the value");
    check("param a = 1 <= 2\nx",
          "1:13: unexpected '<='; a parameter is written 'param a = 0.5 in [0, 2] step 0.1 "
          "\"label\"'");
    check("param a = pi b\nx = a",
          "1:14: no operator between 'pi' and 'b'; write 'pi*b' for a product");
}

}  // namespace
}  // namespace formula
