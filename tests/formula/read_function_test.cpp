// SPDX-License-Identifier: MIT
// The syntax of functions that the user defines.
#include <gtest/gtest.h>

#include "formula/understood.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view tree) {
    EXPECT_EQ(program_of(text), tree) << "formula: " << text;
}

TEST(ReadFunction, has_names_with_or_without_initial_values) {
    check("f(a) = a + 1\nf(x)", "define f(parameter a, value(sum(+ a, + 1))), formula(call f(x))");
    check("f(a, b = 2pi, c = (1, -2)) = a\nf(x)",
          "define f(parameter a, parameter b(product(* 2, . pi)), "
          "parameter c(tuple(1, negate(2))), value(a)), formula(call f(x))");
    check("f(a = g(b = 1, c), x = (y = 1)) = a\nf(x)",
          "define f(parameter a(call g(compare =(b, 1), c)), parameter x(compare =(y, 1)), "
          "value(a)), formula(call f(x))");
    check("f (\n  a,\n  b\n) = a = b\nx",
          "define f(parameter a, parameter b, value(compare =(a, b))), formula(x)");
    check("ring(R, w) = torus(R, w) & (abs(z) <= w/2)\nring(1, 0.2)",
          "define ring(parameter R, parameter w, value(intersection(& call torus(R, w), "
          "& compare <=(call abs(z), product(* w, / 2))))), formula(call ring(1, 0.2))");
}

TEST(ReadFunction, is_defined_only_above_something_that_begins_a_statement) {
    check("hypot(x, y) = 1", "formula(compare =(call hypot(x, y), 1))");
    check("hypot(x, y) = 1\n& z <= 0",
          "formula(intersection(& compare =(call hypot(x, y), 1), & compare <=(z, 0)))");
    check("hypot(x, y) = 1\n  | z = 0\n",
          "formula(union(| compare =(call hypot(x, y), 1), | compare =(z, 0)))");
    check("hypot(x, y) = 1\n  - z^2",
          "formula(compare =(call hypot(x, y), sum(+ 1, - power(z, 2))))");
    check("f(x, y) = 1\n-f(x, y)",
          "define f(parameter x, parameter y, value(1)), formula(negate(call f(x, y)))");
    check("sin(2x) = 1\n- y", "formula(compare =(call sin(product(* 2, . x)), sum(+ 1, - y)))");
    check("f(x) = 1\n(x)", "define f(parameter x, value(1)), formula(x)");
    check("r = 1\n\\ x <= 0", "formula(intersection(& compare =(r, 1), \\ compare <=(x, 0)))");
    check("r = 1\n  + x", "formula(compare =(r, sum(+ 1, + x)))");
    check("a = 1\n+ x = a", "define a(1), formula(compare =(x, a))");
}

void check_error(std::string_view text, std::string_view errors) {
    EXPECT_EQ(syntax_errors_of(text), errors) << "formula: " << text;
}

TEST(ReadFunction, says_what_is_no_parameter) {
    const std::string names =
        "expected a name; a function is defined by the names of its parameters, as in "
        "'f(a, b = 1) = a + b'";
    check_error("f(2) = 1\nx", "1:3: " + names);
    check_error("f(a, 2) = 1\nx", "1:6: " + names);
    check_error("f(a,) = 1\nx", "1:5: " + names);
    check_error("f((a)) = 1\nx", "1:3: " + names);
    const std::string behind =
        "expected ',', '=' or ')' after 'a'; a function is defined by the names of its "
        "parameters, as in 'f(a, b = 1) = a + b'";
    check_error("f(a + 1) = 1\nx", "1:5: " + behind);
    check_error("f(a b) = 1\nx", "1:5: " + behind);
    check_error("f(a <= 1) = 1\nx", "1:5: " + behind);
    check_error("f() = 1\nx", "1:3: a function has at least one parameter; write 'f = ...'");
}

TEST(ReadFunction, has_each_parameter_and_initial_value_once) {
    check_error("f(a, b, a) = 1\nx", "1:9: 'f' has two parameters of the name 'a'");
    check_error("f(a = 1 = 2) = 1\nx", "1:9: the parameter 'a' has an initial value already");
    check_error("f(a = ) = 1\nx", "1:7: expected an expression after '='");
    check_error("f(a = c b) = 1\nx",
                "1:9: no operator between 'c' and 'b'; write 'c*b' for a product");
    check_error("f(a = 1 <= 2) = 1\nx",
                "1:9: unexpected '<='; put brackets around the initial value");
}

TEST(ReadFunction, has_a_value_on_its_line) {
    check_error("f(a) =\nx",
                "1:7: expected an expression after '='; a definition ends with its line");
    check_error("a = sphere(1)\n& x <= 0\na = 1",
                "3:1: the expression has ended above; move the definition of 'a' up, or "
                "join two fields with '|' or '&'");
    check_error("a = sphere(1)\n& x <= 0\nx^2",
                "3:1: a definition ends with its line; put brackets around a longer value");
    check_error("x^2 = 1\nf(a) = a",
                "2:1: the expression has ended above; move the definition of 'f' up, or join two "
                "fields with '|' or '&'");
}

}  // namespace
}  // namespace formula
