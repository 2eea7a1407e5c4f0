// SPDX-License-Identifier: MIT
// Built-in fields by name, their values, and random points around them.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "eval/field_value.h"
#include "field/primitives.h"
#include "graph/build.h"

namespace field {

using Random = std::mt19937_64;

/// Adds a primitive with these numbers as arguments.
inline FieldId add_primitive(Field& field, std::string_view name,
                             std::initializer_list<double> arguments) {
    std::vector<graph::NodeId> nodes;
    for (const double argument : arguments) nodes.push_back(field.graph.constant(argument));
    const Primitive* primitive = find_primitive(name);
    EXPECT_NE(primitive, nullptr) << name;
    return primitive->build(field, nodes);
}

/// An iteration: the unit sphere's distance, folded into shells so many times; 1-Lipschitz.
inline FieldId shells(Field& field, int turns) {
    graph::Graph& g = field.graph;
    const auto variable = [&](graph::VariableId id) { return graph::Expr(g, g.variable(id)); };
    const graph::VariableId distance = g.new_variable("distance"), scale = g.new_variable("scale");
    const graph::Expr d = variable(distance), width = variable(scale);
    const graph::Expr sphere = hypot(variable(graph::variable_x), variable(graph::variable_y),
                                     variable(graph::variable_z)) -
                               1.0;
    return field.add(Iteration{.state = {distance, scale},
                               .start = {sphere.id, g.constant(0.4)},
                               .step = {(abs(d) - width).id, (0.5 * width).id},
                               .limit = g.constant(turns),
                               .escape = std::nullopt,
                               .distance = d.id});
}

/// One primitive as a whole field.
inline Field primitive(std::string_view name, std::initializer_list<double> arguments) {
    Field field;
    field.root = add_primitive(field, name, arguments);
    return field;
}

inline double value(const Field& field, glm::dvec3 point) {
    return eval::value(field, field.root, point, {});
}

/// Evenly in the cube from -size to size.
inline glm::dvec3 random_point(Random& random, double size) {
    std::uniform_real_distribution<double> number(-size, size);
    const double x = number(random), y = number(random), z = number(random);
    return {x, y, z};
}

inline std::string describe(glm::dvec3 p) {
    return testing::PrintToString(std::array{p.x, p.y, p.z});
}

/// Fails where the field's value changes by more than the distance between two points, near and
/// far.
inline void expect_lipschitz(const Field& field, unsigned seed, double size, int pairs) {
    Random random(seed);
    for (int i = 0; i < pairs; ++i) {
        const glm::dvec3 p = random_point(random, size);
        const double nearness = std::exp2(-static_cast<double>(random() % 16));
        const glm::dvec3 q = p + nearness * random_point(random, size);
        const double change = std::abs(value(field, p) - value(field, q));
        ASSERT_LE(change, glm::distance(p, q) * (1 + 1e-9) + 1e-12)
            << "seed " << seed << ": " << describe(p) << " and " << describe(q);
    }
}

}  // namespace field
