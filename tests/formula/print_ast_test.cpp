// SPDX-License-Identifier: MIT
#include "formula/print_ast.h"

#include <gtest/gtest.h>

#include "formula/parse.h"

namespace formula {
namespace {

TEST(PrintAst, shows_the_whole_program_indented) {
    const auto program = parse(
        "param a = 1 in [0, 2] step 0.5 \"how far\"\n"
        "param b = .5\n"
        "s = sphere(a)\n"
        "s & x - 2y >= b \\ -x^2 <= 1\n");
    ASSERT_TRUE(program);
    EXPECT_EQ(print_ast(*program),
              "param a\n"
              "  initial\n"
              "    1\n"
              "  range\n"
              "    0\n"
              "    2\n"
              "  step\n"
              "    0.5\n"
              "  label \"how far\"\n"
              "param b\n"
              "  initial\n"
              "    0.5\n"
              "define s\n"
              "  call sphere\n"
              "    a\n"
              "formula\n"
              "  intersection\n"
              "    & s\n"
              "    & compare >=\n"
              "      sum\n"
              "        + x\n"
              "        - product\n"
              "          * 2\n"
              "          . y\n"
              "      b\n"
              "    \\ compare <=\n"
              "      negate\n"
              "        power\n"
              "          x\n"
              "          2\n"
              "      1\n");
}

}  // namespace
}  // namespace formula
