// SPDX-License-Identifier: MIT
// From a text to a field that has passed through the passes, or to all that is wrong.
#include "compile/compile.h"

#include "compile/understood.h"
#include "eval/field_value.h"

namespace compile {
namespace {

TEST(CompileFormula, runs_the_passes) {
    const Formula formula = understood("sqrt(x^2 + y^2 + z^2) <= 2*3");
    const auto& leaf = std::get<field::Formula>(formula.field[formula.field.root]);
    EXPECT_EQ(leaf.kind, field::Kind::solid);
    const graph::Graph& graph = formula.field.graph;
    const graph::Node& difference = graph[leaf.value];
    ASSERT_EQ(difference.op, graph::Op::sub);
    EXPECT_EQ(graph[difference.arguments[0]].op, graph::Op::hypot3);
    EXPECT_TRUE(graph.is_constant(difference.arguments[1], 6));
}

TEST(CompileFormula, keeps_the_value) {
    const Formula formula = understood("x^2 + 2*y - z = 1");
    EXPECT_DOUBLE_EQ(eval::value(formula.field, formula.field.root, {3, 0.5, 2}, {}), 7);
}

TEST(CompileFormula, has_a_tape_for_each_leaf_that_is_no_distance) {
    EXPECT_EQ(understood("sphere(1) | box(1)").tapes.formulas.size(), 0U);
    EXPECT_EQ(understood("menger(2)").tapes.formulas.size(), 0U);
    const Formula formula = understood("(x*y <= z) | sphere(1) | (x <= y^3)");
    EXPECT_EQ(formula.tapes.formulas.size(), 2U);
    for (const auto& [id, tape] : formula.tapes.formulas) {
        ASSERT_TRUE(std::holds_alternative<field::Formula>(formula.field[id]));
        EXPECT_EQ(tape.roots.size(), 1U);
    }
}

TEST(CompileFormula, reports_all_errors_with_their_places) {
    const auto formula = compile_formula("x + sine(y) + cosine(z) = 0");
    ASSERT_FALSE(formula);
    const base::Diagnostics problems = formula.problems();
    ASSERT_EQ(problems.size(), 2U);
    EXPECT_EQ(problems[0].message, "unknown name 'sine'; did you mean 'sin'?");
    ASSERT_TRUE(problems[0].span);
    EXPECT_EQ(problems[0].span->begin, 4U);
    EXPECT_EQ(problems[1].severity, base::Severity::error);
}

TEST(CompileFormula, reports_warnings_and_goes_on) {
    const Formula formula = understood("unused = 3\nx = 0");
    ASSERT_EQ(formula.warnings.size(), 1U);
    EXPECT_EQ(formula.warnings[0].severity, base::Severity::warning);
    EXPECT_NE(formula.warnings[0].message.find("unused"), std::string::npos);
    EXPECT_TRUE(understood("x = 0").warnings.empty());
}

}  // namespace
}  // namespace compile
