// SPDX-License-Identifier: MIT
#include "formula/vector_functions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "formula/understood.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view errors) {
    EXPECT_EQ(errors_of(text), errors) << "formula: " << text;
}

TEST(VectorFunctions, have_their_textbook_values) {
    EXPECT_EQ(value_of("dot((1, 2, 3), (4, 5, 6))"), 32);
    EXPECT_EQ(value_of("dot((1, 2, 3, 4), (5, 6, 7, 8))"), 70);
    EXPECT_EQ(value_of("c = cross((1, 0, 0), (0, 1, 0))\nc.x + 10c.y + 100c.z"), 100);
    EXPECT_EQ(value_of("length((3, 4))"), 5);
    EXPECT_EQ(value_of("length((2, 3, 6))"), 7);
    EXPECT_EQ(value_of("length((1, 1, 1, 1))"), 2);
    EXPECT_EQ(value_of("length(quaternion(1, -1, 1, -1))"), 2);
    EXPECT_EQ(value_of("distance((1, 2), (4, 6))"), 5);
    EXPECT_EQ(value_of("n = normalize((0, 3, 4))\nn.y"), 0.6);
    EXPECT_EQ(value_of("v = reflect((1, -2, 3), (0, 5, 0))\nv.x + 10v.y + 100v.z"), 321);
    EXPECT_NEAR(value_of("v = turn((1, 0, 0), (0, 0, 2), 90)\nv.x + 10v.y + 100v.z"), 10, 1e-15);
    EXPECT_EQ(value_of("q = conj(quaternion(1, 2, 3, 4))\nq.x + q.y + q.z + q.w"), -8);
}

TEST(VectorFunctions, take_arguments_by_name) {
    EXPECT_EQ(value_of("length(v = (3, 4))"), 5);
    EXPECT_EQ(value_of("q = quaternion(1, d = 4, c = 3, b = 2)\nq.w"), 4);
    EXPECT_EQ(value_of("v = boxfold((3, 0, 0), size = 2)\nv.x"), 1);
}

TEST(VectorFunctions, fold) {
    EXPECT_EQ(value_of("v = boxfold((1.5, -3, 0.5))\nv.x + 10v.y + 100v.z"), 0.5 + 10 + 50);
    EXPECT_EQ(value_of("v = boxfold((1.5, -3, 0.5), 2)\nv.x + 10v.y + 100v.z"), 1.5 - 10 + 50);
    // Inside of the inner radius, between, outside.
    EXPECT_EQ(value_of("v = spherefold((0.25, 0, 0))\nv.x"), 1);
    EXPECT_EQ(value_of("v = spherefold((0.5, 0, 0))\nv.x"), 2);
    EXPECT_EQ(value_of("v = spherefold((0.8, 0, 0))\nv.x"), 1.25);
    EXPECT_EQ(value_of("v = spherefold((3, 0, 0))\nv.x"), 3);
    EXPECT_EQ(value_of("v = spherefold((3, 0, 0), 1, 6)\nv.x"), 12);
}

TEST(VectorFunctions, of_numbers_go_to_each_component) {
    EXPECT_EQ(value_of("v = abs((-1, 2, -3))\nv.x + 10v.y + 100v.z"), 321);
    EXPECT_EQ(value_of("v = mod((5, -1), 3)\nv.x + 10v.y"), 22);
    EXPECT_EQ(value_of("v = mod(7, (5, 4))\nv.x + 10v.y"), 32);
    EXPECT_EQ(value_of("v = max((1, 5), (3, 2), 2)\nv.x + 10v.y"), 53);
    EXPECT_EQ(value_of("v = clamp((-5, 0.5, 5), -1, 1)\nv.x + 10v.y + 100v.z"), 104);
    EXPECT_EQ(value_of("v = mix((0, 10), (10, 20), 0.5)\nv.x + 10v.y"), 155);
    EXPECT_EQ(value_of("v = sqrt((4, 9))\nv.x + 10v.y"), 32);
    EXPECT_EQ(value_of("v = abs(complex(-1, -2))^2\nv.x + 10v.y"), -3 + 40);
}

TEST(VectorFunctions, refuse_other_types) {
    check("length(x)", "1:1: 'length' takes a vector, not a number; it is called 'length(v)'");
    check("dot((1, 2), (1, 2, 3))",
          "1:1: 'dot' takes two vectors of one size, not a vector of 2 "
          "and a vector of 3; it is called 'dot(a, b)'");
    check("cross((1, 2), (1, 2))",
          "1:1: 'cross' takes two vectors of 3, not a vector of 2 and a "
          "vector of 2; it is called 'cross(a, b)'");
    check("distance(1, 2)",
          "1:1: 'distance' takes two vectors of one size, not a number and a "
          "number; it is called 'distance(a, b)'");
    check("normalize(2)",
          "1:1: 'normalize' takes a vector, not a number; it is called 'normalize(v)'");
    check("reflect(2, (1, 2))",
          "1:1: 'reflect' takes two vectors of one size, not a number and a "
          "vector of 2; it is called 'reflect(v, n)'");
    check("conj((1, 2))",
          "1:1: 'conj' takes a complex number or a quaternion, not a vector of 2; "
          "it is called 'conj(q)'");
    check("inverse(triplex(1, 2, 3))",
          "1:1: 'inverse' takes a complex number or a quaternion, not a triplex number; it is "
          "called 'inverse(q)'");
    check("complex(1)",
          "1:1: 'complex' takes 2 numbers or a vector of 2, not a number; it is called "
          "'complex(a, b)'");
    check("quaternion((1, 2, 3))",
          "1:1: 'quaternion' takes 4 numbers or a vector of 4, not a vector of 3; it is called "
          "'quaternion(a, b, c, d)'");
    check("triplex((1, 2, 3), 4)",
          "1:1: 'triplex' takes 3 numbers or a vector of 3, not a vector of 3 and a number; it is "
          "called 'triplex(x, y, z)'");
    check(
        "turn((1, 2, 3), (0, 0, 1), (1, 2))",
        "1:1: 'turn' takes two vectors of 3 and a number, not a vector of 3 and a vector of 3 and "
        "a vector of 2; it is called 'turn(v, axis, degrees)'");
    check("turn((1, 2, 3), (0, 0, 0), 30)", "1:1: the axis of 'turn' must not be zero");
    check("boxfold(1)",
          "1:1: 'boxfold' takes a vector and a number, not a number; it is called "
          "'boxfold(v, size = 1)'");
    check("spherefold(1)",
          "1:1: 'spherefold' takes a vector and two numbers, not a number; it is "
          "called 'spherefold(v, inner = 0.5, outer = 1)'");
    check("length(sphere(1))",
          "1:8: a field cannot be used as an argument of 'length'; join fields "
          "with '|', '&' or '\\'");
    check("max((1, 2), (1, 2, 3))",
          "1:1: 'max' takes vectors of one size, not a vector of 2 and a vector of 3");
    check("sin(complex(1, 2))",
          "1:1: 'sin' takes numbers and vectors, not a complex number; call "
          "it with the components");
    check("hypot((1, 2), 3)",
          "1:1: 'hypot' takes numbers, not a vector of 2; call it with the components");
    check("length()", "1:1: an argument of 'length' is missing; it is called 'length(v)'");
    check("length((1, 2), 3)",
          "1:1: 'length' takes at most 1 argument, not 2; it is called 'length(v)'");
    check("dot(foo, 2)", "1:5: unknown name 'foo'");
}

}  // namespace
}  // namespace formula
