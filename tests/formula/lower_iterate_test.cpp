// SPDX-License-Identifier: MIT
// Iterations: what they compute, and what is wrong with them. Estimates are compared with distances
// in fractals_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "formula/understood.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view errors) {
    EXPECT_EQ(errors_of(text), errors) << "formula: " << text;
}

const field::Iteration iteration_of(const field::Field& field) {
    return std::get<field::Iteration>(field[field.root]);
}

glm::dvec3 colour_at(std::string_view text, glm::dvec3 point) {
    const base::Result<Lowered> result = understand(text);
    if (!result) {
        ADD_FAILURE() << report_of(text);
        return {};
    }
    const auto colour = eval::colour(result->field, result->field.root, point, {});
    EXPECT_TRUE(colour) << text;
    return colour.value_or(glm::dvec3(-1));
}

TEST(LowerIterate, assignments_follow_one_another) {
    // Fibonacci's numbers: b is taken from the new a.
    EXPECT_EQ(value_of("iterate a = 1, b = 0 for 9: b = a + b; a = b - a; distance = b"), 34);
    EXPECT_EQ(value_of("iterate a = 1 for 5: half = a/2; a = a + 2half; distance = a"), 32);
}

TEST(LowerIterate, state_that_is_not_assigned_stays) {
    EXPECT_EQ(value_of("iterate a = 1, b = 3 for 4: a = a*b; distance = a"), 81);
}

TEST(LowerIterate, i_is_the_number_of_finished_turns) {
    EXPECT_EQ(value_of("iterate a = 0 for 5: a = a + i; distance = a"), 10);
    EXPECT_EQ(value_of("i = 7\niterate a = 0 for 5: a = a + i; distance = a"), 35);
    EXPECT_EQ(value_of("iterate i = 2 for 3: i = i^2; distance = i"), 256);
}

TEST(LowerIterate, until_is_asked_before_each_turn) {
    const std::string doubling =
        "iterate a = x for 6 until a > 10: a = 2a; distance = turns + a/100";
    EXPECT_DOUBLE_EQ(value_at(doubling, {11, 0, 0}), 0.11);
    EXPECT_DOUBLE_EQ(value_at(doubling, {3, 0, 0}), 2.12);
    EXPECT_EQ(value_at(doubling, {0.1, 0, 0}), -INFINITY);
    EXPECT_DOUBLE_EQ(value_at("iterate a = x for 6 until 1 > a: a = a/2; distance = a", {6, 0, 0}),
                     0.75);
    EXPECT_DOUBLE_EQ(value_at("iterate a = x for 6 until a < 1: a = a/2; distance = a", {6, 0, 0}),
                     0.75);
}

TEST(LowerIterate, may_end_by_several_comparisons) {
    const auto turns = [](const std::string& until, double x) {
        return value_at(
            "iterate a = x, b = 8 for 9 until " + until + ": a = 2a; b = b/2; distance = turns",
            {x, 0, 0});
    };
    EXPECT_EQ(turns("a > 10 | b < 3", 1), 2);
    EXPECT_EQ(turns("a > 10 | b < 3", 6), 1);
    EXPECT_EQ(turns("a > 10 & b < 3", 1), 4);
    EXPECT_EQ(turns("a > 10 & b < 3", 6), 2);
    EXPECT_EQ(turns("a > 3 \\ (b >= 3)", 1), 2);
    EXPECT_EQ(turns("a > 3 \\ (b >= 3)", 0.25), 4);
    EXPECT_EQ(turns("(a > 10 | b < 3) & i > 2", 6), 3);
    EXPECT_EQ(turns("a > 1e9 & b < 3", 1), -INFINITY);
}

TEST(LowerIterate, the_limit_may_be_a_parameter) {
    EXPECT_EQ(value_of("param n = 3\niterate a = 1 for n: a = 2a; distance = a"), 8);
    EXPECT_EQ(value_of("param n = 1e9\niterate a = 0 for n: a = a + 1; distance = a"), 10000);
}

TEST(LowerIterate, vectors_are_state_by_components) {
    EXPECT_EQ(value_at("iterate p = (x, y, z) for 2: p = 2p + (1, 0, 0); distance = p.x + 10p.y",
                       {1, 2, 0}),
              87);
    const base::Result<Lowered> result =
        understand("iterate q = quaternion(x, y, z, 0) for 2 until length(q) > 4: q = q^2");
    ASSERT_TRUE(result);
    const field::Iteration it = iteration_of(result->field);
    EXPECT_EQ(result->field.graph.name(it.state[0]), "q.x");
    EXPECT_EQ(result->field.graph.name(it.state[3]), "q.w");
}

TEST(LowerIterate, growth_is_the_derivative_of_the_orbit) {
    const double r = 1.25;
    EXPECT_NEAR(value_at("iterate q = quaternion(x, y, z, 0) for 3: q = q^2; distance = growth",
                         {0.6 * r, 0, 0.8 * r}),
                8 * std::pow(r, 7), 1e-12 * 8 * std::pow(r, 7));
    // By dual numbers, and the Frobenius norm of 8 times the unit matrix.
    EXPECT_NEAR(value_at("iterate p = (x, y, z) for 3: p = (2p.x, 2p.y, 2p.z); distance = growth",
                         {1, 2, 3}),
                8 * std::sqrt(3), 1e-12);
}

TEST(LowerIterate, growth_is_carried_as_one_number_where_rules_know_it) {
    const auto state_of = [](const char* step) {
        const std::string text =
            std::string("iterate q = quaternion(x, y, z, 0) for 5 until length(q) > 4: q = ") +
            step;
        const base::Result<Lowered> result = understand(text);
        EXPECT_TRUE(result) << report_of(text);
        return result ? iteration_of(result->field).state.size() : 0;
    };
    EXPECT_EQ(state_of("q^2 + quaternion(0.1, 0.2, 0, 0)"), 4U + 2) << "growth, potential";
    EXPECT_EQ(state_of("quaternion(q.x^2 - q.y^2 - q.z^2 - q.w^2, 2q.x*q.y, 2q.x*q.z, 2q.x*q.w)"),
              4U + 1 + 4 * 3)
        << "by dual numbers";
}

TEST(LowerIterate, the_radius_is_found_however_it_is_written) {
    const glm::dvec3 point{0.9, 0.7, -0.3};
    const auto with = [&](const char* until) {
        return value_at(std::string("param B = 4 in [2, 9]\nsize = B\niterate q = quaternion(x, y, "
                                    "z, 0) for 8 until ") +
                            until + ": q = q^2",
                        point);
    };
    const double expected = with("length(q) > size");
    EXPECT_TRUE(std::isfinite(expected));
    for (const char* until :
         {"size < length(q)", "dot(q, q) > size^2", "q.x^2 + q.y^2 + q.z^2 + q.w^2 > B^2",
          "sqrt(dot(q, q)) >= B", "length(conj(q)) > size"}) {
        EXPECT_NEAR(with(until), expected, 1e-12) << until;
    }
}

TEST(LowerIterate, smooth_turns_are_the_turns_at_the_radius_and_grow_smoothly) {
    const auto at = [](double r) {
        return value_at(
            "iterate q = quaternion(x, y, z, 0) for 9 until length(q) > 4: q = q^2; distance = "
            "smooth_turns",
            {0, r, 0});
    };
    EXPECT_NEAR(at(2 * (1 + 1e-12)), 1, 1e-9) << "a square of 4";
    EXPECT_NEAR(at(std::sqrt(2) * (1 + 1e-12)), 2, 1e-9);
    for (double r = 1.1; r < 3; r += 0.01) EXPECT_NEAR(at(r), at(r + 1e-6), 1e-4) << r;
    const auto linear = [](double r) {
        return value_at(
            "iterate p = (x, y, z) for 9 until length(p) > 4: p = 2p; distance = smooth_turns",
            {0, r, 0});
    };
    EXPECT_NEAR(linear(1 + 1e-12), 2, 1e-9);
    EXPECT_NEAR(linear(3), std::log2(4.0 / 3), 1e-12);
}

TEST(LowerIterate, a_colour_is_a_vector_or_goes_through_the_palette) {
    const glm::dvec3 p{0.5, 0.25, 0.125};
    EXPECT_EQ(colour_at("iterate a = x for 3: a = 2a; distance = a; colour = (a, y, turns)", p),
              glm::dvec3(4, 0.25, 3));
    const char* by_number = "iterate a = x for 3: a = 2a; distance = a; colour = a/8";
    EXPECT_NE(colour_at(by_number, p), glm::dvec3(0));
    EXPECT_LT(glm::distance(colour_at(by_number, p), colour_at(by_number, p + glm::dvec3(1, 0, 0))),
              1e-12)
        << "of period 1";
}

TEST(LowerIterate, stands_where_a_field_can_stand) {
    check("A = iterate q = (x, y, z) for 3: q = 2q; distance = length(q)/growth - 1\nA | sphere(1)",
          "");
    check("A = iterate q = (x, y, z) for 3: q = 2q; distance = length(q)/growth - 1\nA + 1",
          "2:1: a field cannot be used in arithmetic; join fields with '|', '&' or '\\'");
}

TEST(LowerIterate, the_number_of_turns_is_checked) {
    check("iterate a = 1 for x: a = 2a; distance = a",
          "1:19: the number of turns must not depend on x, y or z");
    check("iterate a = 1 for -1: a = 2a; distance = a", "1:19: the number of turns is 0 or more");
    check("iterate a = 1 for 0/0: a = 2a; distance = a", "1:19: the number of turns is 0 or more");
    check("iterate a = 1 for 10001: a = 2a; distance = a",
          "1:19: an iteration has at most 10,000 turns");
    check("iterate a = 1 for (1, 2): a = 2a; distance = a",
          "1:19: a vector of 2 cannot be used as the number of turns; take its length(…) or a "
          "component such as .x");
}

TEST(LowerIterate, state_keeps_its_type) {
    check("iterate a = sphere(1) for 3: a = a; distance = 1",
          "1:13: 'a' must be a number or a vector, not a field");
    check("iterate a = 1 for 3: a = (a, a); distance = 1",
          "1:22: 'a' begins as a number and cannot become a vector of 2");
    check("iterate q = quaternion(x, y, z, 0) for 3: q = q.x; distance = 1",
          "1:43: 'q' begins as a quaternion and cannot become a number");
    check("iterate z = 1 for 3: z = 2; distance = 1",
          "1:9: 'z' is a coordinate and cannot be redefined\n"
          "1:22: 'z' is a coordinate and cannot be redefined");
    check("iterate a = 1 for 3: y = 2; distance = 1",
          "1:22: 'y' is a coordinate and cannot be redefined");
}

TEST(LowerIterate, an_end_is_a_comparison_of_size) {
    check("iterate a = x for 3 until a = 4: a = 2a; distance = 1",
          "1:27: numbers are seldom equal; end an iteration by '<' or '>'");
}

TEST(LowerIterate, says_why_there_is_no_distance) {
    check("iterate q = (x, y, z) for 3: q = 2q",
          "1:1: the distance cannot be told without 'until length(q) > 4'; or give 'distance = …' "
          "in the body");
    check("iterate q = (x, y, z) for 3 until q.x > 4: q = 2q",
          "1:35: the distance cannot be told from this condition; write 'until length(q) > 4'; or "
          "give 'distance = …' in the body");
    check("iterate q = (x, y, z) for 3 until length(q) > x: q = 2q",
          "1:35: the distance cannot be told from this condition; write 'until length(q) > 4'; or "
          "give 'distance = …' in the body");
    check("iterate q = (x, y, z) for 3 until length(q) > 4: q = q/2",
          "1:1: the distance cannot be told, since it is unknown how 'q' grows from turn to turn; "
          "or give 'distance = …' in the body");
    check("iterate q = quaternion(x, y, z, 0) for 3 until length(q) > 1: q = q^2",
          "1:48: the distance cannot be told unless the radius is above 1; or give 'distance = …' "
          "in the body");
    check("iterate q = (x, y, z) for 3: q = 2q; distance = 1; colour = smooth_turns",
          "1:1: 'smooth_turns' cannot be told without 'until length(q) > 4'");
    check(
        "iterate q = (x, y, z) for 3 until length(q) > 4: q = if(mod(i, 2) < 1, 2q, 3q); "
        "colour = smooth_turns",
        "1:1: 'smooth_turns' cannot be told, since 'q' grows differently from turn to turn");
}

TEST(LowerIterate, has_a_number_as_distance) {
    check("iterate a = x for 3: a = 2a; distance = (a, 1)",
          "1:41: a vector of 2 cannot be used as a distance; take its length(…) or a component "
          "such as .x");
}

TEST(LowerIterate, says_that_a_distance_is_no_field) {
    check("iterate p = (x, y, z) for 3: p = 2p; distance = sphere(1)",
          "1:49: a field cannot be used as a distance; write a number, such as '(length(p) - "
          "1)/growth'");
    check("iterate p = (x, y, z) for sphere(): p = 2p; distance = 1",
          "1:27: a field cannot be used as the number of turns; write a number in its place");
}

TEST(LowerIterate, says_how_a_name_outlives_its_turn) {
    const std::string lost =
        "'u' lasts for one turn only; to carry it along, give it an initial value: 'iterate p = "
        "…, u = …'";
    check("iterate p = x for 3: u = 2p; p = u; distance = u", "1:48: " + lost);
    check("iterate p = x for 3: u = 2p; p = u; distance = 1; colour = u", "1:60: " + lost);
    check("iterate p = x for 3 until u > 1: u = 2p; p = u; distance = 1", "1:27: " + lost);
    check("iterate p = x for 3: p = p + u; u = 1; distance = 1", "1:30: " + lost);
    EXPECT_EQ(value_of("u = 7\niterate p = x for 3: u = 2p; p = u; distance = u"), 7);
}

TEST(LowerIterate, says_when_its_answers_are_known) {
    check("iterate p = x for 3: p = p*turns; distance = 1",
          "1:28: 'turns' is known after the last turn, to 'distance' and 'colour'; before, 'i' is "
          "the number of turns");
    check("iterate p = x for 3 until growth > 1: p = 2p; distance = 1",
          "1:27: 'growth' is known after the last turn, to 'distance' and 'colour'");
    check("iterate p = x for 3: p = smooth_turns; distance = 1",
          "1:26: 'smooth_turns' is known after the last turn, to 'distance' and 'colour'");
    check("growth = 0",
          "1:1: unknown name 'growth'; to define it, type an equation such as x^2 + "
          "y^2 + z^2 = 1 on the next line");
}

TEST(LowerIterate, says_what_a_colour_is) {
    check("iterate a = x for 3: a = 2a; distance = a; colour = (a, 1)",
          "1:53: a colour is a number or a vector of 3, not a vector of 2");
    check("iterate a = x for 3: a = 2a; distance = a; colour = sphere(1)",
          "1:53: a colour is a number or a vector of 3, not a field");
}

TEST(LowerIterate, reports_all_errors_once) {
    check("iterate a = p, b = 1 for 3:\n  a = a + s; b = (b, b)\n  distance = t1",
          "1:13: unknown name 'p'\n"
          "2:11: unknown name 's'\n"
          "3:14: unknown name 't1'");
}

}  // namespace
}  // namespace formula
