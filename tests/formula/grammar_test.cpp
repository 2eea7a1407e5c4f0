// SPDX-License-Identifier: MIT
#include "formula/grammar.h"

#include <gtest/gtest.h>

#include "formula/understood.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view tree) {
    EXPECT_EQ(tree_of(text), tree) << "formula: " << text;
}

TEST(Grammar, products_bind_tighter_than_sums_and_both_run_from_the_left) {
    check("x + y*z - 1", "sum(+ x, + product(* y, * z), - 1)");
    check("x - y - z", "sum(+ x, - y, - z)");
    check("x/y/z*2", "product(* x, / y, / z, * 2)");
    check("(x - y)*z", "product(* sum(+ x, - y), * z)");
    check("x - (y - z)", "sum(+ x, - sum(+ y, - z))");
}

TEST(Grammar, powers_run_from_the_right_and_bind_tighter_than_the_sign_before_them) {
    check("x^y^z", "power(x, power(y, z))");
    check("-x^2", "negate(power(x, 2))");
    check("(-x)^2", "power(negate(x), 2)");
    check("2^-x", "power(2, negate(x))");
    check("2^-x^2", "power(2, negate(power(x, 2)))");
    check("-x*y", "product(* negate(x), * y)");
    check("a*-b", "product(* a, * negate(b))");
    check("x - -y", "sum(+ x, - negate(y))");
    check("+x", "x");
    check("--x", "x");
    check("-+-+-x", "negate(x)");
    check("2*x^2/3", "product(* 2, * power(x, 2), / 3)");
}

TEST(Grammar, a_product_is_implied_after_a_number) {
    check("2x", "product(* 2, . x)");
    check("3(x+1)", "product(* 3, . sum(+ x, + 1))");
    check("5sqrt(2)", "product(* 5, . call sqrt(2))");
    check("2 x", "product(* 2, . x)");
    check("2x^2", "product(* 2, . power(x, 2))");
    check("x^2y", "product(* power(x, 2), . y)");
    check("1/2x", "product(* 1, / 2, . x)");
    check("-2x", "product(* negate(2), . x)");
    check("x - 2y", "sum(+ x, - product(* 2, . y))");
}

TEST(Grammar, a_product_is_implied_after_a_closing_bracket) {
    check("(x+1)(x-1)", "product(* sum(+ x, + 1), . sum(+ x, - 1))");
    check("(1+a)z^2", "product(* sum(+ 1, + a), . power(z, 2))");
    check("(x)2", "product(* x, . 2)");
    check("(x) .5", "product(* x, . 0.5)");
    check("sin(2x)cos(y)", "product(* call sin(product(* 2, . x)), . call cos(y))");
    check("f(x)(y)z", "product(* call f(x), . y, . z)");
    check("(x)-y", "sum(+ x, - y)");
    check("(2)(3)4x", "product(* 2, . 3, . 4, . x)");
}

TEST(Grammar, numbers_end_where_their_exponent_has_no_digits) {
    check("2e+1", "20");
    check("2e", "product(* 2, . e)");
    check("2ex", "product(* 2, . ex)");
    check("2e+x", "sum(+ product(* 2, . e), + x)");
    check("1e1x", "product(* 10, . x)");
    check(".5", "0.5");
    check("1.", "1");
    check("5.x", "product(* 5, . x)");
    check("2.5e-3", "0.0025");
}

TEST(Grammar, comparisons_bind_tighter_than_set_operators) {
    check("x = 1 & y <= 2", "intersection(& compare =(x, 1), & compare <=(y, 2))");
    check("x < 1 | y > 2 | z >= 3",
          "union(| compare <(x, 1), | compare >(y, 2), | compare >=(z, 3))");
    check("x + 1 = 2y", "compare =(sum(+ x, + 1), product(* 2, . y))");
}

TEST(Grammar, intersection_and_difference_bind_tighter_than_union) {
    check("a | b & c", "union(| a, | intersection(& b, & c))");
    check("a & b \\ c & d", "intersection(& a, & b, \\ c, & d)");
    check("a \\ (b | c)", "intersection(& a, \\ union(| b, | c))");
}

TEST(Grammar, calls_have_any_arguments_and_tuples_two_parts_or_more) {
    check("f()", "call f");
    check("f (x, y+1)", "call f(x, sum(+ y, + 1))");
    check("f((1, 2), c = (3, 4))", "call f(tuple(1, 2), compare =(c, tuple(3, 4)))");
    check("((x))", "x");
    check("f(x = 1, y <= 2 | z)", "call f(compare =(x, 1), union(| compare <=(y, 2), | z))");
}

TEST(Grammar, an_expression_runs_over_lines_and_comments) {
    check("x^2 # first\n + y^2\n = # last\n 1", "compare =(sum(+ power(x, 2), + power(y, 2)), 1)");
    check("max(x,\n    y)", "call max(x, y)");
}

TEST(Grammar, no_product_crosses_the_end_of_a_line) {
    check("2\nx",
          "2:1: no operator between '2' and 'x'; a product does not cross the end of a line, "
          "write '*'");
    check("(2\nx)",
          "2:1: no operator between '2' and 'x'; a product does not cross the end of a "
          "line, write '*'");
    check("(x)\n(y)",
          "2:1: no operator between ')' and '('; a product does not cross the end of a "
          "line, write '*'");
    check("(sin\n(x))",
          "2:1: no operator between 'sin' and '('; a product does not cross the end of "
          "a line, write '*'");
    check("(2 # two\nx)",
          "2:1: no operator between '2' and 'x'; a product does not cross the end of "
          "a line, write '*'");
}

TEST(Grammar, spans_cover_the_brackets) {
    const std::string_view text = "(x + 1)*f(2, (y)) <= -(3)^2";
    const base::Result<Program> program = parse(text);
    ASSERT_TRUE(program);
    std::string spans;
    for (const Expression& it : program->expressions) {
        spans += std::string(text.substr(it.span.begin, it.span.end - it.span.begin)) + "; ";
    }
    EXPECT_EQ(spans,
              "x; 1; (x + 1); 2; y; f(2, (y)); (x + 1)*f(2, (y)); (3); 2; (3)^2; -(3)^2; "
              "(x + 1)*f(2, (y)) <= -(3)^2; ");
}

}  // namespace
}  // namespace formula
