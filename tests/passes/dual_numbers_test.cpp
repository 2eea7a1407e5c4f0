// SPDX-License-Identifier: MIT
// Derivatives that an iteration carries, against differences.
#include "passes/dual_numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "eval/field_value.h"
#include "graph/build.h"

namespace passes {
namespace {

using glm::dvec3;
using graph::Expr;
using graph::NodeId;

constexpr std::array point{graph::variable_x, graph::variable_y, graph::variable_z};

/// Folds and scalings of u, and with them the largest of what they leave.
struct Folds {
    field::Field field;
    field::Iteration iteration;
    NodeId largest{};

    explicit Folds(int turns) {
        const auto variable = [&](graph::VariableId id) {
            return Expr(field.graph, field.graph.variable(id));
        };
        const std::array names{"u", "v", "largest"};
        for (const char* name : names) iteration.state.push_back(field.graph.new_variable(name));
        const Expr x = variable(point[0]), y = variable(point[1]), z = variable(point[2]);
        const Expr u = variable(iteration.state[0]), v = variable(iteration.state[1]);
        const Expr best = variable(iteration.state[2]);
        for (const Expr start : {x + 0.3 * y, hypot(y, z), x - z})
            iteration.start.push_back(start.id);
        const Expr size = 0.5 * min(abs(1.0 - 3.0 * u), v + x);
        for (const Expr step : {abs(2.0 * u - 1.0), abs(1.0 - 2.0 * v), max(best, size)})
            iteration.step.push_back(step.id);
        iteration.limit = field.graph.constant(turns);
        iteration.distance = (best + 0.1 * z).id;
    }
    double answer(NodeId distance, dvec3 p) {
        field::Iteration asked = iteration;
        asked.distance = distance;
        field.root = field.add(asked);
        return eval::value(field, field.root, p, {});
    }
};

TEST(DualNumbers, are_the_slopes_of_differences) {
    constexpr unsigned seed = 81;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int turns = 0; turns < 5; ++turns) {
        Folds it(turns);
        const NodeId distance = it.iteration.distance;
        const auto slopes = add_derivatives(it.field.graph, it.iteration, std::array{distance})[0];
        int kinks = 0;
        for (int i = 0; i < 100; ++i) {
            const double px = number(random), py = number(random), pz = number(random);
            const dvec3 p(px, py, pz);
            constexpr double h = 1e-7;
            for (int axis = 0; axis < 3; ++axis) {
                dvec3 e(0);
                e[axis] = h;
                const double ahead = (it.answer(distance, p + e) - it.answer(distance, p)) / h;
                const double behind = (it.answer(distance, p) - it.answer(distance, p - e)) / h;
                if (std::abs(ahead - behind) > 1e-5) {
                    ++kinks;
                    continue;
                }
                ASSERT_NEAR(it.answer(slopes[static_cast<std::size_t>(axis)], p), ahead, 1e-5)
                    << turns << " turns, seed " << seed << ": " << px << ' ' << py << ' ' << pz;
            }
        }
        EXPECT_LT(kinks, 3) << turns << " turns, seed " << seed;
    }
}

TEST(DualNumbers, leave_out_what_does_not_change) {
    Folds it(2);
    const auto slopes =
        add_derivatives(it.field.graph, it.iteration, std::array{it.iteration.distance});
    EXPECT_EQ(it.iteration.state.size(), 3U + 2 + 3 + 2) << "u not by z, v not by x";
    EXPECT_EQ(it.iteration.start.size(), it.iteration.state.size());
    EXPECT_EQ(it.iteration.step.size(), it.iteration.state.size());
    EXPECT_EQ(slopes.size(), 1U);
}

}  // namespace
}  // namespace passes
