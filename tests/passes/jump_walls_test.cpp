// SPDX-License-Identifier: MIT
// Walls are 0 where an expression jumps, and nowhere between.
#include "passes/jump_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "eval/tape.h"
#include "graph/build.h"
#include "graph/print.h"

namespace passes {
namespace {

using graph::Expr;
using graph::Graph;

constexpr unsigned seed = 20261124;

TEST(JumpWalls, are_crossed_wherever_the_value_jumps) {
    Graph graph;
    const Expr x(graph, graph.variable(graph::variable_x)),
        y(graph, graph.variable(graph::variable_y)), z(graph, graph.variable(graph::variable_z));
    const Expr a = 2.0 * x - y, b = 0.5 * (floor(a) + floor(3.0 * z));
    const std::vector<Expr> cases{floor(a),
                                  b - floor(b),
                                  sign(a + z) * x,
                                  a - 2.0 * floor(0.5 * a),
                                  select_less(x, y, x * x, floor(y) * z),
                                  apply(graph::Op::ceil, b)};
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> anywhere(-3, 3), near(-0.05, 0.05);
    int jumps = 0;
    for (const Expr f : cases) {
        ASSERT_TRUE(jumps_at_planes(graph, f.id));
        const auto walls = jump_walls(graph, f.id);
        for (int k = 0; k < 2000; ++k) {
            const glm::dvec3 p(anywhere(random), anywhere(random), anywhere(random));
            const glm::dvec3 q = p + glm::dvec3(near(random), near(random), near(random));
            // No argument changes by more than 4 times the way, so no wall is reached before that.
            double nearest = 1e30;
            for (const graph::NodeId wall : walls) {
                const double way = eval::evaluate(graph, wall, p);
                EXPECT_GE(way, 0);
                nearest = std::min(nearest, way);
            }
            // Nor does the value between jumps change by more than 7 times the way.
            const double change = eval::evaluate(graph, f.id, q) - eval::evaluate(graph, f.id, p);
            const bool jumped = std::abs(change) > 7 * glm::length(q - p) + 1e-9;
            jumps += jumped;
            if (jumped) {
                EXPECT_LE(nearest, 4 * glm::length(q - p)) << "seed " << seed << "\n"
                                                           << graph::print(graph, std::array{f.id});
            }
        }
    }
    EXPECT_GT(jumps, 200);
}

TEST(JumpWalls, are_unknown_where_jumps_are_on_no_planes) {
    Graph graph;
    const Expr x(graph, graph.variable(graph::variable_x)),
        y(graph, graph.variable(graph::variable_y));
    for (const Expr f :
         {floor(x * y), sign(sin(x)), floor(x) + floor(x * x), atan2(y, x) + floor(x)}) {
        EXPECT_FALSE(jumps_at_planes(graph, f.id)) << graph::print(graph, std::array{f.id});
        EXPECT_TRUE(jump_walls(graph, f.id).empty());
    }
    EXPECT_FALSE(jumps_at_planes(graph, (x * y).id));
}

}  // namespace
}  // namespace passes
