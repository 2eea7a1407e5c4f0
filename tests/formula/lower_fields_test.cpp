// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "formula/understood.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view errors) {
    EXPECT_EQ(errors_of(text), errors) << "formula: " << text;
}

TEST(LowerFields, set_operators_are_minimum_maximum_and_negative) {
    const glm::dvec3 point{0.5, 2, -1};
    EXPECT_DOUBLE_EQ(value_at("x <= 0 | y <= 0 | z <= 0", point), -1);
    EXPECT_DOUBLE_EQ(value_at("x <= 0 & y <= 0 & z <= 0", point), 2);
    EXPECT_DOUBLE_EQ(value_at("z <= 0 \\ x <= 0", point), -0.5);
    EXPECT_DOUBLE_EQ(value_at("z <= 0 & x <= 0 \\ y <= 0", point), 0.5);
    EXPECT_DOUBLE_EQ(value_at("z <= 0 \\ (x <= 0 | y <= 0)", point), -0.5);
    EXPECT_DOUBLE_EQ(value_at("x <= 0 | z <= 0 & y <= 0", point), 0.5);
}

TEST(LowerFields, sheets_go_where_they_make_sense) {
    check("x = 0 & sphere(1)", "");
    check("sphere(1) & x", "");
    check("x = 0 \\ sphere(1)", "");
    check("x = 0 | sphere(1)", "");
    check("x = 0 | y = 0", "");
    check("x = 0 & y <= 0 & sphere(1)", "");
    check("(x = 0 | y = 0) & sphere(1)", "");
}

TEST(LowerFields, a_sheet_has_no_complement) {
    check("complement(x = 0)",
          "1:12: a sheet has no inside, so it has no complement; write '<=' instead of '='");
    check("complement(x)",
          "1:12: a sheet has no inside, so it has no complement; write 'F <= 0' for "
          "the solid of a formula F");
    check("sphere(1) \\ x = 0",
          "1:13: a sheet has no inside, so it has no complement; write '<=' instead of '='");
    check("difference(sphere(1), x = 0)",
          "1:23: a sheet has no inside, so it has no complement; write '<=' instead of '='");
    check("complement(x = 0 & sphere(1))",
          "1:12: a sheet has no inside, so it has no complement; write 'F <= 0' for the solid of a "
          "formula F");
}

TEST(LowerFields, two_sheets_intersect_in_a_curve) {
    check("x = 0 & y = 0",
          "1:9: two sheets intersect in a curve, which has no surface; write '<=' "
          "instead of '='");
    check("x = 0 & sphere(1) & y = 0",
          "1:21: two sheets intersect in a curve, which has no surface; "
          "write '<=' instead of '='");
    check("intersection(x, y)",
          "1:17: two sheets intersect in a curve, which has no surface; write "
          "'F <= 0' for the solid of a formula F");
}

TEST(LowerFields, long_chains_are_balanced_and_keep_their_order) {
    std::string text = "x <= 0";
    for (int i = 1; i < 1000; ++i) text += " | x <= " + std::to_string(i);
    const base::Result<Lowered> result = understand(text);
    ASSERT_TRUE(result) << report_of(text);
    const field::Field& field = result->field;
    const std::vector<field::FieldId> leaves = field::leaves(field, field.root);
    ASSERT_EQ(leaves.size(), 1000u);
    double last = -1e9;
    for (const field::FieldId leaf : leaves) {
        const double constant = -eval::value(field, leaf, {0, 0, 0}, std::vector<double>{0.0});
        EXPECT_GT(constant, last);
        last = constant;
    }
    std::size_t depth = 0;
    for (field::FieldId id = field.root;
         const auto* node = std::get_if<field::Union>(&field[id]);) {
        id = node->a;
        ++depth;
    }
    EXPECT_LE(depth, 10u);
}

}  // namespace
}  // namespace formula
