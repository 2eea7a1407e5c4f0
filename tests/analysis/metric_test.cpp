// SPDX-License-Identifier: MIT
// What values say about the distance, by construction and by proof.
#include "analysis/metric.h"

#include <gtest/gtest.h>

#include "field/blends.h"
#include "field/palette.h"
#include "field/shapes.h"
#include "graph/build.h"
#include "numeric/real.h"

namespace analysis {
namespace {

using field::Field;
using field::FieldId;

Metric metric_of(const Field& field, FieldId id, double lipschitz) {
    return metric(field, id, [=](FieldId) { return lipschitz; });
}

FieldId scalar(Field& field) {
    return field.add(field::Formula{field.graph.variable(graph::variable_x)});
}

TEST(Metric, of_built_in_solids_is_exact) {
    for (const char* name : {"sphere", "torus"}) {
        const Field field = field::primitive(name, {1, 0.5});
        EXPECT_EQ(metric_of(field, field.root, 9), Metric::exact) << name;
    }
}

TEST(Metric, of_built_in_solids_is_the_distance_to_the_surface) {
    // Walking by an exact distance along its gradient ends on the surface.
    field::Random random(7);
    for (const auto& [name, arguments] :
         {std::pair{"sphere", std::vector{1.0}}, std::pair{"box", std::vector{1.0, 0.5, 0.75}},
          std::pair{"torus", std::vector{1.0, 0.35}}, std::pair{"cylinder", std::vector{0.5, 1.0}},
          std::pair{"cone", std::vector{1.0, 1.0}}, std::pair{"capsule", std::vector{0.5, 1.0}},
          std::pair{"plane", std::vector{0.0, 1.0, 2.0, 0.5}}}) {
        Field field;
        std::vector<graph::NodeId> nodes;
        for (const double argument : arguments) nodes.push_back(field.graph.constant(argument));
        field.root = field::find_primitive(name)->build(field, nodes);
        ASSERT_EQ(metric_of(field, field.root, 9), Metric::exact) << name;
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 p = field::random_point(random, 3);
            const double d = value(field, p);
            if (d < 0.01) continue;
            constexpr double h = 1e-6;
            glm::dvec3 gradient;
            for (int k = 0; k < 3; ++k) {
                glm::dvec3 step(0);
                step[k] = h;
                gradient[k] = (value(field, p + step) - value(field, p - step)) / (2 * h);
            }
            // Kinks of the distance are where two points of the surface are the nearest.
            if (glm::length(gradient) < 0.999) continue;
            EXPECT_NEAR(value(field, p - d * gradient), 0, 1e-4) << name << field::describe(p);
        }
    }
}

TEST(Metric, of_a_formula_is_a_bound_where_its_gradient_is_at_most_1) {
    Field field;
    const FieldId leaf = scalar(field);
    EXPECT_EQ(metric_of(field, leaf, 1), Metric::bound);
    EXPECT_EQ(metric_of(field, leaf, std::nextafter(1.0, 2)), Metric::none);
    EXPECT_EQ(metric_of(field, leaf, numeric::infinity), Metric::none);
}

TEST(Metric, of_joined_fields_is_a_bound_at_best) {
    Field field;
    const FieldId a = field::add_primitive(field, "sphere", {1});
    const FieldId b = field::add_primitive(field, "box", {1, 1, 1});
    const FieldId none = scalar(field);
    const FieldId both = field.add(field::Union{a, b});
    EXPECT_EQ(metric_of(field, both, 9), Metric::bound);
    EXPECT_EQ(metric_of(field, field.add(field::Intersection{a, b}), 9), Metric::bound);
    const FieldId red = field::coloured(field, a, field::coordinates(field.graph));
    EXPECT_EQ(metric_of(field, smooth_union(field, red, b, field.graph.constant(1)), 9),
              Metric::bound);
    EXPECT_EQ(metric_of(field, displace(field, b, field.graph.constant(1)), 9), Metric::none);
    EXPECT_EQ(metric_of(field, field.add(field::Complement{a}), 9), Metric::exact);
    EXPECT_EQ(metric_of(field, field.add(field::Union{both, none}), 9), Metric::none);
    EXPECT_EQ(metric_of(field, field.add(field::Union{both, none}), 1), Metric::bound);
}

TEST(Metric, of_an_iteration_is_an_estimate) {
    Field field;
    const FieldId loop = field.add(field::Iteration{
        {}, {}, {}, field.graph.constant(1), {}, field.graph.variable(graph::variable_x)});
    EXPECT_EQ(metric_of(field, loop, 1), Metric::estimate);
    EXPECT_EQ(metric_of(field, field.add(field::Union{loop, scalar(field)}), 9), Metric::none);
}

}  // namespace
}  // namespace analysis
