// SPDX-License-Identifier: MIT
#include "formula/print_formula.h"

#include <gtest/gtest.h>

#include <set>

#include "formula/random_program.h"
#include "formula/understood.h"
#include "property.h"

namespace formula {
namespace {

std::string printed(std::string_view text) {
    const base::Result<Program> program = parse(text);
    return program ? print_formula(*program) : syntax_errors_of(text);
}

void check(std::string_view text) { EXPECT_EQ(printed(text), std::string(text) + "\n"); }

TEST(PrintFormula, writes_no_more_brackets_than_it_takes) {
    check("x^2 + y^2 - 2x*y/3 = 1");
    check("-x^2 + (-x)^2^-y - -x*(x + 1)");
    check("(x + 1)(x - 1)y - 2z^2 + 5sqrt(2)(1 + x^2)z = 1/2x");
    check("a & b \\ (c & d) | (e | f) & x <= 1");
    check("x - (y - z) - -(-x)");
    check("(x^2)^3(y)2*p.x.y + (1, 2).x");
    check("2(e1) + 2e + (2)3 - (x)(-y)");
    EXPECT_EQ(printed("(((x)) + ((y*z)))"), "x + y*z\n");
    EXPECT_EQ(printed("2 x(y)*(z) .5"), "2x(y)*(z)0.5\n");
}

TEST(PrintFormula, writes_statements_a_line_each) {
    check("f(a, b = (1, 2)) = a & b = 2\nc = 2.5e-30\nf(x)");
    check(
        "param a = (on) in [0, 2] logarithmic step 0.1 \"l\" group \"g\" tooltip \"t\"\n"
        "param s = \"b\" in [\"a\", \"b\"]\nparam cut = off \"l\"\nparam - x");
    check(
        "m = iterate q = x, s = 1 for 12 until length(q) > 4:\n"
        "    q = q^2 + c\n    s = (q = 2)\n    distance = s\n    colour = q\n"
        "m");
    EXPECT_EQ(printed("iterate q = x for 3: colour = (q); q = 1"),
              "iterate q = x for 3:\n    q = 1\n    colour = q\n");
}

TEST(PrintFormula, keeps_words_that_mean_something_else_apart) {
    check("(param)");
    check("param a = (on) step +(1, 2)\nparam b = on + 1\nparam c = angle angle\niterate");
}

TEST(PrintFormula, that_is_parsed_again_gives_the_same_tree) {
    std::set<std::size_t> kinds;
    std::size_t programs = 0;
    const auto numbers =
        rc::gen::container<std::vector<std::uint16_t>>(rc::gen::arbitrary<std::uint16_t>());
    expect_property(20250611, 20000, 400, [&] {
        const Program program = RandomProgram(*numbers).program();
        const std::string text = print_formula(program);
        const Reading reading = read(text);
        RC_ASSERT(list_of(text, reading.errors) == "");
        RC_ASSERT(print_ast(*reading.program) == print_ast(program));
        RC_ASSERT(print_formula(*reading.program) == text);
        for (const Expression& it : program.expressions) kinds.insert(it.node.index());
        ++programs;
    });
    EXPECT_EQ(programs, 20000u);
    EXPECT_EQ(kinds.size(), std::variant_size_v<ExpressionNode> - 1) << "all kinds but Broken";
}

}  // namespace
}  // namespace formula
