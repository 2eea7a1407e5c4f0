// SPDX-License-Identifier: MIT
// Many alike operands become data.
#include "shader/family.h"

#include <gtest/gtest.h>

#include <string>

#include <fmt/format.h>

#include "shader/programs.h"

namespace shader {
namespace {

/// A function of the number of a copy, and the operands that it makes.
std::string copies(int count, const std::string& combination = "union(ball, {})") {
    return "ball(i) = translate(sphere(0.01 + 0.0001 i), (sin(i), sin(2i + 1), sin(3i + 2)))\n" +
           fmt::format(fmt::runtime(combination), count);
}

std::string text_of(const std::string& formula, Features features = {}) {
    return program_source(field_of(formula), features).fragment;
}

std::size_t families_in(const std::string& formula) {
    return program_source(field_of(formula), {}).families.size();
}

TEST(Families, keep_the_text_short_however_many_members_there_are) {
    for (const char* combination :
         {"union(ball, {})", "smooth_union(ball, {}, 0.1)", "box(1) \\ union(ball, {})",
          "smooth_difference(box(1), union(ball, {}), 0.01)",
          "repeat(union(ball, {}), (4, 4, 4))"}) {
        const std::size_t few = text_of(copies(20, combination)).size();
        const std::size_t many = text_of(copies(1000, combination)).size();
        EXPECT_LT(many, few + 40) << combination;
        EXPECT_LT(many, 40000) << combination;
    }
    EXPECT_LT(text_of(copies(5000)).size(), text_of(copies(20)).size() + 40);
}

TEST(Families, begin_with_sixteen_members) {
    EXPECT_EQ(families_in(copies(15)), 0);
    EXPECT_EQ(families_in(copies(16)), 1);
    EXPECT_EQ(families_in(copies(15, "smooth_union(ball, {}, 0.1)")), 0);
    EXPECT_EQ(families_in(copies(16, "smooth_union(ball, {}, 0.1)")), 1);
}

TEST(Families, are_text_where_that_is_asked_for_or_needed) {
    const std::string formula = copies(20);
    Features features;
    for (const char* tracer : {"interval", "second-order"}) {
        features.tracer = tracer;
        EXPECT_FALSE(has(text_of(formula, features), "family")) << tracer;
    }
    features.tracer = "sphere";
    EXPECT_TRUE(has(text_of(formula, features), "family"));
    features.operands_as_text = true;
    EXPECT_FALSE(has(text_of(formula, features), "family"));
}

TEST(Families, are_the_alike_ones_in_a_row) {
    const std::string many = copies(20, "union(ball, {})");
    EXPECT_EQ(families_in(many + " | plane() | union(ball, 17)"), 1) << "a plane is alike enough";
    EXPECT_EQ(families_in(many + " | x^2 <= y | union(ball, 17)"), 2);
    EXPECT_EQ(families_in(many + " | julia()"), 1);
    EXPECT_EQ(families_in(many + " & box(1)"), 1);
}

TEST(Families, are_made_of_what_is_cut_out_by_one_after_the_other) {
    std::string formula = "ball(i) = translate(sphere(0.1), (sin(i), 0, 0))\nbox(1)";
    for (int i = 0; i < 20; ++i) formula += fmt::format(" \\ ball({})", i);
    EXPECT_EQ(families_in(formula), 1);
}

TEST(Families, hold_what_differs_and_no_more) {
    const auto numbers_in = [](const std::string& formula) {
        const ProgramSource source = program_source(field_of(formula), {});
        EXPECT_EQ(source.families.size(), 1);
        EXPECT_EQ(source.families[0].kinds.size(), 1);
        return source.families[0].sizes[0];
    };
    EXPECT_EQ(numbers_in("ball(i) = translate(sphere(0.1), (i - 1, 2i, 3i))\nunion(ball, 16)"), 3);
    EXPECT_EQ(numbers_in("ball(i) = translate(sphere(0.1), (i, 0, 0))\nunion(ball, 16)"), 1);
    EXPECT_EQ(numbers_in("ball(i) = translate(sphere(i), (i, i, 0))\nunion(ball, 16)"), 1);
    EXPECT_EQ(numbers_in("cube(i) = translate(box(0.1 i), (sin(i), 2, cos(i)))\nunion(cube, 16)"),
              3);
}

TEST(Families, say_of_what_kind_a_member_is) {
    const ProgramSource source = program_source(
        field_of("thing(i) = translate(if(mod(i, 3) < 1, box(0.1), sphere(0.2)), (i, 0, 0))\n"
                 "union(thing, 30)"),
        {});
    ASSERT_EQ(source.families.size(), 1);
    EXPECT_EQ(source.families[0].kinds.size(), 2);
    EXPECT_EQ(source.families[0].members.size(), 30);
    EXPECT_NE(source.families[0].members[1], source.families[0].members[2]);
    EXPECT_EQ(source.families[0].members[0], source.families[0].members[1]);
}

TEST(Families, follow_parameters) {
    const ProgramSource source = program_source(
        field_of("param a = 1\nball(i) = translate(sphere(a), (a*i, 0, 0))\nunion(ball, 16)"), {});
    ASSERT_EQ(source.families.size(), 1);
    EXPECT_EQ(source.families[0].numbers.parameters.size(), 1);
}

}  // namespace
}  // namespace shader
