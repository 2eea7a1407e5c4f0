// SPDX-License-Identifier: MIT
// Running derivatives against differences, and estimates of sets whose distance is known.
#include "passes/distance_estimate.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <random>

#include <glm/geometric.hpp>

#include "eval/field_value.h"
#include "graph/build.h"

namespace passes {
namespace {

using glm::dvec3;
using graph::Expr;

/// A field of one iteration that is being built.
struct Iterating {
    field::Field field;
    field::Iteration iteration;

    Expr number(double value) { return {field.graph, value}; }
    Expr variable(graph::VariableId id) { return {field.graph, field.graph.variable(id)}; }
    Expr state(const char* name, Expr start) {
        const graph::VariableId id = field.graph.new_variable(name);
        iteration.state.push_back(id);
        iteration.start.push_back(start.id);
        return variable(id);
    }
    Expr x() { return variable(graph::variable_x); }
    Expr y() { return variable(graph::variable_y); }
    Expr z() { return variable(graph::variable_z); }

    /// The same iteration with another answer.
    double answer(graph::NodeId distance, dvec3 p) {
        field::Iteration asked = iteration;
        asked.distance = distance;
        field.root = field.add(asked);
        return eval::value(field, field.root, p, {});
    }
};

/// Some turns of a map with powers, folds, a constant state and one that only depends on the point.
Iterating mixed(int turns) {
    Iterating it;
    const Expr a = it.state("a", it.x() + 0.5 * it.y());
    const Expr b = it.state("b", it.y() * it.z());
    const Expr s = it.state("s", 0.3 * it.x());
    const Expr n = it.state("n", it.number(0));
    const Expr step_a = a * a - b * b + 0.2 * s + it.x();
    const Expr step_b = 2.0 * a * abs(b) + sin(b) + 0.1 * n;
    for (const Expr step : {step_a, step_b, s * it.z(), n + 1.0}) {
        it.iteration.step.push_back(step.id);
    }
    it.iteration.limit = it.number(turns).id;
    return it;
}

TEST(JacobianNorm, is_that_of_differences) {
    constexpr unsigned seed = 61;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int turns = 0; turns < 4; ++turns) {
        Iterating it = mixed(turns);
        const std::array orbit{it.field.graph.variable(it.iteration.state[0]),
                               it.field.graph.variable(it.iteration.state[1])};
        const graph::NodeId norm = add_jacobian_norm(it.field.graph, it.iteration, 2);
        for (int i = 0; i < 50; ++i) {
            const double px = number(random), py = number(random), pz = number(random);
            const dvec3 p(px, py, pz);
            double squares = 0;
            constexpr double h = 1e-6;
            for (int axis = 0; axis < 3; ++axis) {
                dvec3 e(0);
                e[axis] = h;
                for (const graph::NodeId part : orbit) {
                    const double slope =
                        (it.answer(part, p + e) - it.answer(part, p - e)) / (2 * h);
                    squares += slope * slope;
                }
            }
            const double expected = std::sqrt(squares);
            ASSERT_NEAR(it.answer(norm, p), expected, 1e-6 * (1 + expected))
                << turns << " turns, seed " << seed << ": " << px << ' ' << py << ' ' << pz;
        }
    }
}

TEST(JacobianNorm, carries_only_what_changes_with_the_point) {
    Iterating it = mixed(2);
    add_jacobian_norm(it.field.graph, it.iteration, 2);
    EXPECT_EQ(it.iteration.state.size(), 4U + 3 + 2 + 3) << "n changes by none, s not by y";
    Iterating plane;
    const Expr a = plane.state("a", plane.x());
    plane.iteration.step.push_back((a * a + plane.y()).id);
    add_jacobian_norm(plane.field.graph, plane.iteration, 1);
    EXPECT_EQ(plane.iteration.state.size(), 3U) << "by z it does not change";
    EXPECT_EQ(it.iteration.start.size(), it.iteration.state.size());
    EXPECT_EQ(it.iteration.step.size(), it.iteration.state.size());
}

/// z -> factor z from z = p, until |z| > 8, with the running derivative as one number.
double linear_estimate(double factor, double limit, dvec3 p) {
    Iterating it;
    const Expr a = it.state("a", it.x()), b = it.state("b", it.y()), c = it.state("c", it.z());
    for (const Expr part : {a, b, c}) it.iteration.step.push_back((factor * part).id);
    it.iteration.limit = it.number(limit).id;
    const Expr length = hypot(a, b, c);
    it.iteration.escape = (length - 8.0).id;
    const graph::VariableId running = it.field.graph.new_variable("growth");
    const graph::NodeId growth =
        add_growth(it.field.graph, it.iteration,
                   {running, it.number(1).id, (std::abs(factor) * it.variable(running)).id});
    const Escape escape{false, it.number(factor).id, it.number(8).id};
    const graph::NodeId distance =
        distance_estimate(it.field.graph, it.iteration, length.id, escape, growth);
    return it.answer(distance, p);
}

TEST(DistanceEstimate, of_a_growing_ball_is_its_distance) {
    for (const double factor : {2.0, -2.0, 1.5}) {
        const double radius = 8 * std::pow(std::abs(factor), -10);
        for (const double r : {1.01 * radius, 0.3, 1.0, 5.0, 20.0}) {
            EXPECT_NEAR(linear_estimate(factor, 10, {0.6 * r, 0, 0.8 * r}), r - radius, 1e-12 * r)
                << factor << ' ' << r;
        }
        EXPECT_EQ(linear_estimate(factor, 10, {0, 0.99 * radius, 0}), -INFINITY);
    }
}

TEST(DistanceEstimate, of_squares_is_half_the_potential_over_its_gradient) {
    constexpr int limit = 6;
    Iterating it;
    // Complex squares in the plane: the Jacobian is 2|z| times a turn, its norm sqrt(2) times that.
    const Expr a = it.state("a", it.x()), b = it.state("b", it.y());
    for (const Expr step : {a * a - b * b, 2.0 * a * b}) it.iteration.step.push_back(step.id);
    it.iteration.limit = it.number(limit).id;
    const Expr length = hypot(a, b);
    it.iteration.escape = (length - 4.0).id;
    const graph::NodeId growth = add_jacobian_norm(it.field.graph, it.iteration, 2);
    const Escape escape{true, it.number(2).id, it.number(4).id};
    const graph::NodeId distance =
        distance_estimate(it.field.graph, it.iteration, length.id, escape, growth);
    const double radius = std::pow(4.0, std::exp2(-limit));
    for (const double r : {1.001 * radius, 1.2, 2.0, 10.0}) {
        const double expected = 0.5 * r * std::log(r / radius) / std::sqrt(2.0);
        EXPECT_NEAR(it.answer(distance, {0.6 * r, -0.8 * r, 7}), expected, 1e-12) << r;
    }
}

TEST(AddGrowth, carries_the_square_where_lengths_only_multiply) {
    Iterating it;
    const Expr a = it.state("a", it.x()), b = it.state("b", it.y());
    for (const Expr step : {a * a - b * b + 0.3, 2.0 * a * b - 0.2}) {
        it.iteration.step.push_back(step.id);
    }
    it.iteration.limit = it.number(5).id;
    const graph::VariableId running = it.field.graph.new_variable("growth");
    const Expr factor = 2.0 * hypot(a, b), growth = it.variable(running);
    const dvec3 p(0.7, -0.4, 0);
    double expected = 1;
    std::complex<double> z(p.x, p.y);
    for (int i = 0; i < 5; ++i) {
        expected *= 2 * std::abs(z);
        z = z * z + std::complex<double>(0.3, -0.2);
    }
    const graph::NodeId value =
        add_growth(it.field.graph, it.iteration, {running, it.number(1).id, (factor * growth).id});
    EXPECT_NEAR(it.answer(value, p), expected, 1e-12 * expected);
    const graph::NodeId step = it.iteration.step.back();
    for (const graph::NodeId id : reachable(it.field.graph, std::array{step})) {
        EXPECT_NE(it.field.graph[id].op, graph::Op::hypot) << "a root at every turn";
        EXPECT_NE(it.field.graph[id].op, graph::Op::sqrt) << "a root at every turn";
    }
}

TEST(AddGrowth, adds_what_is_added) {
    Iterating it;
    const Expr a = it.state("a", it.x());
    it.iteration.step.push_back((a * a + it.x()).id);
    it.iteration.limit = it.number(3).id;
    const graph::VariableId running = it.field.graph.new_variable("growth");
    const Expr step = 2.0 * hypot(a, it.y()) * it.variable(running) + 1.0;
    const graph::NodeId value =
        add_growth(it.field.graph, it.iteration, {running, it.number(1).id, step.id});
    EXPECT_EQ(value, it.field.graph.variable(running)) << "carried as it is";
}

TEST(HeuristicOrder, adds_and_multiplies_like_degrees) {
    Iterating it;
    const Expr a = it.state("a", it.x()), b = it.state("b", it.y()), x = it.x();
    const std::array orbit = {it.iteration.state[0], it.iteration.state[1]};
    const auto order = [&](Expr e) { return heuristic_order(it.field.graph, e.id, orbit); };
    EXPECT_EQ(order(x * x), 0);
    EXPECT_EQ(order(a * b * x + b), 2);
    EXPECT_EQ(order(pow(hypot(a, b), it.number(8)) * sin(8.0 * a) + x), 8);
    EXPECT_EQ(order(sqrt(a * a + b * b * b)), 1.5);
    EXPECT_EQ(order(a * a / hypot(a, b)), 1);
    EXPECT_EQ(order(exp(x)), 0);
    EXPECT_EQ(order(select_less(a, b, a * a, b)), 2);
    EXPECT_EQ(order(exp(a)), std::nullopt);
    EXPECT_EQ(order(pow(a, x)), std::nullopt);
}

}  // namespace
}  // namespace passes
