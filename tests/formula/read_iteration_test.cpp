// SPDX-License-Identifier: MIT
// The syntax of iterations.
#include <gtest/gtest.h>

#include "formula/understood.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view tree) {
    EXPECT_EQ(program_of(text), tree) << "formula: " << text;
}

constexpr std::string_view three_lines =
    "iterate q = p, s = 1 for n until length(q) > 4:\n"
    "    q = q^2 + c\n"
    "    s = min(s, q.x)\n"
    "    colour = s\n";
constexpr std::string_view three_parts =
    "iterate(state q(p), state s(1), for(n), until(compare >(call length(q), 4)), "
    "set q(sum(+ power(q, 2), + c)), set s(call min(s, component x(q))), colour(s))";

TEST(ReadIteration, takes_the_indented_lines_as_its_body) {
    check(three_lines, "formula(" + std::string(three_parts) + ")");
    check("a = " + std::string(three_lines) + "a & x = 1",
          "define a(" + std::string(three_parts) +
              "), formula(intersection(& a, & compare =(x, 1)))");
    check("f(c) = " + std::string(three_lines) + "f(2)",
          "define f(parameter c, value(" + std::string(three_parts) + ")), formula(call f(2))");
    check("iterate q = 1 for 3:\n\n   # why\n  q = (q\n+ 1)\n      s = 2; u = 3\n",
          "formula(iterate(state q(1), for(3), set q(sum(+ q, + 1)), set s(2), set u(3)))");
    check("\titerate q = 1 for 3:\n\t    q = 2", "formula(iterate(state q(1), for(3), set q(2)))");
    check("    iterate q = 1 for 3:\n\tq = 2", "formula(iterate(state q(1), for(3), set q(2)))");
}

TEST(ReadIteration, takes_the_rest_of_its_line_as_its_body) {
    const std::string_view tree = "iterate(state q(1), for(3), set q(sum(+ q, + 1)), distance(q))";
    check("iterate q = 1 for 3: q = q + 1; distance = q", "formula(" + std::string(tree) + ")");
    check("iterate q = 1 for 3: q = q + 1; distance = q;", "formula(" + std::string(tree) + ")");
    check("a = iterate q = 1 for 3: q = q + 1; distance = q\na",
          "define a(" + std::string(tree) + "), formula(a)");
}

TEST(ReadIteration, a_head_may_run_over_lines) {
    const std::string tree = "iterate(state q(1), for(3), until(compare >=(q, 2)), set q(2))";
    check("iterate q = 1\n    for 3\n    until q >= 2:\n    q = 2", "formula(" + tree + ")");
    check("iterate q = (\n1) for 3 until q >= 2:\n    q = 2", "formula(" + tree + ")");
    check("f(\n  a) = iterate q = 1 for 3 until q >= 2:\n    q = 2\nx",
          "define f(parameter a, value(" + tree + ")), formula(x)");
    check("a =\n  iterate q = 1 for 3 until q >= 2:\n    q = 2\nx",
          "define a(" + tree + "), formula(x)");
}

TEST(ReadIteration, may_end_by_several_comparisons) {
    const auto check_until = [](std::string_view until, const std::string& tree) {
        check("iterate q = 1 for 3 until " + std::string(until) + ":\n  q = 2",
              "formula(iterate(state q(1), for(3), until(" + tree + "), set q(2)))");
    };
    const std::string two = "union(| compare >(q, 2), | compare <(q, 1))";
    check_until("q > 2 | q < 1", two);
    check_until("(q > 2 | q < 1)", two);
    check_until("q > 2\n    | q < 1", two);
    check_until("q > 2 & q < x \\ r > 1",
                "intersection(& compare >(q, 2), & compare <(q, x), \\ compare >(r, 1))");
}

TEST(ReadIteration, a_definition_ends_where_its_body_ends) {
    check("a = iterate q = 1 for 3:\n  q = 2\n-x = a",
          "define a(iterate(state q(1), for(3), set q(2))), formula(compare =(negate(x), a))");
    check("a = iterate q = 1 for 3:\n  q = 2\nb = iterate q = 1 for 3: q = 2\nparam c = 1\na",
          "define a(iterate(state q(1), for(3), set q(2))), "
          "define b(iterate(state q(1), for(3), set q(2))), param c(initial(1)), formula(a)");
}

TEST(ReadIteration, the_words_are_names_elsewhere) {
    check("iterate = 1\niterate*x", "define iterate(1), formula(product(* iterate, * x))");
    check("for = 1\nuntil = 2 for\nfor + until + iterate",
          "define for(1), define until(product(* 2, . for)), "
          "formula(sum(+ for, + until, + iterate))");
    check("iterate(x)", "formula(call iterate(x))");
    check("a = iterate\na", "define a(iterate), formula(a)");
}

TEST(ReadIteration, words_of_the_head_are_no_factors) {
    check("iterate q = 2 for 3 until (q) > 2(q): q = 1",
          "formula(iterate(state q(2), for(3), until(compare >(q, product(* 2, . q))), set q(1)))");
}

void check_error(std::string_view text, std::string_view errors) {
    EXPECT_EQ(syntax_errors_of(text), errors) << "formula: " << text;
}

TEST(ReadIteration, says_what_its_head_lacks) {
    const std::string body = "\n  q = 2";
    check_error("iterate 3 = 1 for 3:" + body, "1:9: expected a name after 'iterate'");
    check_error("iterate for = 1 for 3:" + body, "1:9: expected a name after 'iterate'");
    check_error("iterate q = 1, for 3:" + body, "1:16: expected a name after ','");
    check_error("iterate q for 3:" + body, "1:11: expected '=' after 'q'");
    check_error("iterate q = for 3:" + body, "1:13: expected an expression after '='");
    check_error("iterate q = 1 +:" + body, "1:16: expected an expression after '+'");
    check_error("iterate q = 1:" + body,
                "1:14: expected 'for' and the number of turns, such as 'for 12'");
    check_error("iterate q = 1 until q > 2:" + body,
                "1:15: expected 'for' and the number of turns, such as 'for 12'");
    check_error("iterate q = 1" + body,
                "1:14: expected 'for' and the number of turns, such as 'for 12'");
    check_error("iterate q = 1 for:" + body, "1:18: expected an expression after 'for'");
    check_error("iterate q = 1 for 3" + body, "1:20: expected ':' and the body after '3'");
    check_error("iterate q = 1 for 3 until q:" + body,
                "1:28: expected a comparison after 'until', such as 'until length(q) > 4'");
    check_error("iterate q = 1 for 3 until:" + body, "1:26: expected an expression after 'until'");
    check_error("iterate q = 1 for 3 until q >:" + body, "1:30: expected an expression after '>'");
    check_error("iterate q = 1 for 3 until 1 < q < 2:" + body,
                "1:33: comparisons cannot be chained; join two with '&'");
    check_error("iterate q = 1 | 2 for 3:" + body,
                "1:15: unexpected '|'; an iteration begins like 'iterate q = p for 12 until "
                "length(q) > 4:'");
    check_error("iterate q = 1 for 3 until q > 2 &:" + body,
                "1:34: expected an expression after '&'");
    check_error("iterate q = a b for 3:" + body,
                "1:15: no operator between 'a' and 'b'; write 'a*b' for a product");
    check_error("iterate q = 1, 2 for 3:" + body, "1:16: expected a name after ','");
}

TEST(ReadIteration, names_that_it_carries_have_one_initial_value) {
    check_error("iterate q = 1 = 2 for 3: q = 2", "1:15: 'q' has an initial value already");
    check_error("iterate q = 1, q = 2 for 3: q = 2", "1:16: 'q' has an initial value already");
    check_error("iterate colour = 1 for 3: q = 2",
                "1:9: 'colour' is given in the body, after the last turn; choose another name");
    check_error("iterate distance = 1 for 3: q = 2",
                "1:9: 'distance' is given in the body, after the last turn; choose another name");
}

TEST(ReadIteration, says_where_a_body_is_missing) {
    const std::string missing =
        "the iteration has no body; write its assignments such as 'q = q^2 + c' below, indented";
    check_error("iterate q = 1 for 3:", "1:21: " + missing);
    check_error("iterate q = 1 for 3: ;", "1:21: " + missing);
    check_error("a = iterate q = 1 for 3: # q = 2\na = x", "1:25: " + missing);
    check_error("  a = iterate q = 1 for 3:\n  x = 2\na = x", "1:27: " + missing);
    check_error("iterate q = 1 for 3:\nq = q + 1",
                "2:1: the body of an iteration must be indented more than the line that it begins "
                "on");
    check_error("a = iterate q = 1, s = 2 for 3:\nq = q + 1\ns = q\na",
                "2:1: the body of an iteration must be indented more than the line that it begins "
                "on");
}

TEST(ReadIteration, says_what_is_no_assignment) {
    const std::string head = "iterate q = 1 for 3:\n  ";
    check_error(head + "q^2", "2:3: expected an assignment such as 'q = q^2 + c'");
    check_error(head + "q", "2:3: expected an assignment such as 'q = q^2 + c'");
    check_error(head + "2 = q", "2:3: expected an assignment such as 'q = q^2 + c'");
    check_error(head + "q.x = 2", "2:3: expected an assignment such as 'q = q^2 + c'");
    check_error(head + "q = q^2\n    + c",
                "3:5: expected an assignment; one that takes several lines needs brackets around "
                "its value");
    check_error(head + "q =",
                "2:6: expected an expression after '='; an assignment ends with its line");
    check_error(head + "q = 1 +",
                "2:10: expected an expression after '+'; an assignment ends with its line");
    check_error(head + "q = 1 = 2",
                "2:9: an assignment has one '='; put ';' or a new line before the next one");
    check_error(head + "q = 1 < 2",
                "2:9: a comparison is no value; choose between values with 'if'");
    check_error(head + "q = sphere(1) | box()",
                "2:17: fields cannot be joined in an iteration; join its result");
    check_error(head + "q = 1, 2", "2:8: unexpected ','; an assignment ends with ';' or its line");
    check_error(head + "q = 1 s = 2",
                "2:11: an assignment has one '='; put ';' or a new line before the next one");
    check_error(head + "distance = 1\n  distance = 2", "3:3: 'distance' has a value already");
    check_error(head + "q = iterate p = 1 for 2: p = 3",
                "2:7: an iteration cannot stand in another; define it as a function above");
    check_error(head + "q = 1 +\n  s = (2 3)",
                "2:10: expected an expression after '+'; an assignment ends with its line\n"
                "3:10: no operator between '2' and '3'; write '2*3' for a product");
}

TEST(ReadIteration, stands_alone) {
    check_error("sphere(1) & iterate q = 1 for 3: q = 2",
                "1:21: an iteration stands alone; give it a name in a definition and use that");
    check_error("param a = iterate q = 1 for 3: q = 2\nx",
                "1:19: an iteration stands alone; give it a name in a definition and use that");
    check_error("iterate q = 1 for 3: q = 2\n& sphere(1)",
                "2:1: the iteration has ended above; give it a name in a definition to join it "
                "with other fields");
    check_error("iterate q = 1 for 3: q = 2\nparam a = 1",
                "2:1: the expression has ended above; move the parameter up");
    check_error("iterate q = 1 for 3:\n  q = 2\na = 1",
                "3:1: the expression has ended above; move the definition of 'a' up, or "
                "join two fields with '|' or '&'");
    check_error("a = iterate q = 1 for 3: q = 2",
                "1:31: the formula has nothing to show; type an equation such as x^2 + y^2 + z^2 = "
                "1 below its parameters");
    check_error("x = 1; y = 2",
                "1:6: a ';' stands only in an iteration; write each definition on its line");
    check_error("x: y", "1:2: a ':' stands only before the body of an iteration");
}

}  // namespace
}  // namespace formula
