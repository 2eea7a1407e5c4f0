// SPDX-License-Identifier: MIT
// Components of vectors: `p.x`.
#include <gtest/gtest.h>

#include "formula/understood.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view tree) {
    EXPECT_EQ(tree_of(text), tree) << "formula: " << text;
}

void check_error(std::string_view text, std::string_view errors) {
    EXPECT_EQ(syntax_errors_of(text), errors) << "formula: " << text;
}

TEST(Components, stand_behind_names_brackets_and_calls) {
    check("p.x", "component x(p)");
    check("p.xzy", "component xzy(p)");
    check("(a + b).y", "component y(sum(+ a, + b))");
    check("(1, 2, 3).z", "component z(tuple(1, 2, 3))");
    check("f(x).w", "component w(call f(x))");
    check("(p).x", "component x(p)");
    check("p.xy.x.x", "component x(component x(component xy(p)))");
}

TEST(Components, bind_tighter_than_powers_signs_and_products) {
    check("-p.x^2", "negate(power(component x(p), 2))");
    check("(a+b).y^2", "power(component y(sum(+ a, + b)), 2)");
    check("2^p.x^q.y", "power(2, power(component x(p), component y(q)))");
    check("3 p.x", "product(* 3, . component x(p))");
    check("3p.x p", "1:6: no operator between 'x' and 'p'; write 'x*p' for a product");
    check("(a)p.x/q.y", "product(* a, . component x(p), / component y(q))");
    check("p.x*q.y - p.y*q.x",
          "sum(+ product(* component x(p), * component y(q)), "
          "- product(* component y(p), * component x(q)))");
    check("f(x).x(y)", "1:7: no operator between 'x' and '('; write 'x*(' for a product");
}

TEST(Components, leave_numbers_as_they_are) {
    check("2.x", "product(* 2, . x)");
    check("(x).5", "product(* x, . 0.5)");
    check("(x).5.y", "1:6: a '.' before letters stands only next to a name or a ')'");
    check("2.5x", "product(* 2.5, . x)");
    check("x^2.y", "product(* power(x, 2), . y)");
}

TEST(Components, have_spans_from_the_operand_to_the_letters) {
    const std::string_view text = "(p).x + f(2).zy.x";
    const base::Result<Program> program = parse(text);
    ASSERT_TRUE(program);
    std::string spans;
    for (const Expression& it : program->expressions) {
        spans += std::string(text.substr(it.span.begin, it.span.end - it.span.begin)) + "; ";
    }
    EXPECT_EQ(spans, "p; (p).x; 2; f(2); f(2).zy; f(2).zy.x; (p).x + f(2).zy.x; ");
}

TEST(Components, are_the_letters_x_y_z_and_w_four_at_most) {
    check_error("p.q = 1", "1:3: 'q' is no component; the components are x, y, z and w");
    check_error("p.xq = 1", "1:3: 'xq' is no component; the components are x, y, z and w");
    check_error("p.x2 = 1", "1:3: 'x2' is no component; the components are x, y, z and w");
    check_error("p.xyzwx = 1", "1:3: a vector has at most 4 components; write at most 4 letters");
}

TEST(Components, touch_the_point_on_both_sides) {
    const std::string missing = "expected a component after '.', as in 'p.x'";
    check_error("p.", "1:3: " + missing);
    check_error("a = p.\nx = a", "1:7: " + missing);
    check_error("p. x", "1:4: " + missing);
    check_error("p.\nx", "2:1: " + missing);
    check_error("f(p.) = 1", "1:5: " + missing);
    check_error("p..x", "1:3: " + missing);
    const std::string apart = "a '.' before letters stands only next to a name or a ')'";
    check_error("p .x", "1:3: " + apart);
    check_error("2..x", "1:3: " + apart);
    check_error("p.5", "1:2: no operator between 'p' and '.5'; write 'p*.5' for a product");
}

}  // namespace
}  // namespace formula
