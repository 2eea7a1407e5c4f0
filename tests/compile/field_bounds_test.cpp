// SPDX-License-Identifier: MIT
// Lipschitz constants of whole fields, by the rules from their parts.
#include "compile/field_bounds.h"

#include <cmath>

#include <gtest/gtest.h>

#include "compile/understood.h"

namespace compile {
namespace {

const analysis::Region ball{glm::dvec3(0), glm::dvec3(2), true};

/// Of the whole field.
double lipschitz(const char* text, std::optional<analysis::Region> region = ball) {
    const Formula formula = understood(text);
    const std::vector<double> parameters(formula.field.graph.parameter_count(), 0.0);
    FieldBounds bounds(formula.field, formula.tapes, region, parameters);
    return bounds.lipschitz(formula.field.root, {});
}

TEST(FieldBounds, of_distances_and_what_keeps_them_are_one) {
    for (const char* text :
         {"sphere(1)", "menger(2) | box()", "julia() \\ torus()", "offset(menger(2), 0.1)",
          "smooth_union(julia(), sphere(1))", "morph(menger(2), sphere(1), 0.5)"}) {
        EXPECT_EQ(lipschitz(text), 1) << text;
        EXPECT_EQ(lipschitz(text, {}), 1) << text;
    }
}

TEST(FieldBounds, of_blends_are_those_of_the_steepest_operand) {
    const double bound = lipschitz("smooth_union(menger(1), x^2 + y^2 + z^2 <= 1)");
    EXPECT_GE(bound, 4);
    EXPECT_LE(bound, 4.5);
    EXPECT_EQ(lipschitz("smooth_union(menger(1), 1/x <= 1)"), numeric::infinity);
    EXPECT_EQ(lipschitz("smooth_union(menger(1), x^2 <= 1)", {}), numeric::infinity);
}

TEST(FieldBounds, add_up_displacements) {
    for (const char* text : {"displace(sphere(1), 0.1 sin(5x))", "displace(menger(1), 0.1 sin(5x))",
                             "offset(displace(box(), 0.1 sin(5x)), 0.2)"}) {
        EXPECT_GE(lipschitz(text), 1.5) << text;
        EXPECT_LE(lipschitz(text), 1.51) << text;
    }
    EXPECT_EQ(lipschitz("displace(menger(1), floor(x))"), numeric::infinity);
}

}  // namespace
}  // namespace compile
