// SPDX-License-Identifier: MIT
// Coordinates about another origin: the same values, and exact ones near the origin however far off
// that is.
#include "passes/recentre.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "analysis/formulas.h"
#include "eval/operators.h"
#include "eval/random_expression.h"
#include "eval/tape.h"
#include "graph/print.h"
#include "passes/pipeline.h"

namespace passes {
namespace {

constexpr unsigned seed = 20261122;
using Random = std::mt19937_64;

field::Field field_of(graph::Graph graph, graph::NodeId value) {
    field::Field field;
    field.graph = std::move(graph);
    field.root = field.add(field::Formula{.value = value});
    run(field);
    return field;
}

template <class Build>
field::Field field_of(Build build) {
    analysis::Formula formula(build);
    return field_of(std::move(formula.graph), formula.value);
}

graph::NodeId value_node(const field::Field& field) {
    return std::get<field::Formula>(field[field.root]).value;
}

/// In the precision of T from what does not depend on the point on.
template <class T>
double value_at(const field::Field& field, const std::array<double, 3>& point,
                std::vector<double> parameters) {
    const eval::Tape tape = eval::make_tape(field.graph, std::array{value_node(field)});
    std::vector<double> registers;
    parameters.resize(field.graph.parameter_count());
    eval::load_parameters<double>(tape, parameters, registers);
    const auto rounded = [](double x) { return static_cast<double>(static_cast<T>(x)); };
    for (double& number : registers) number = rounded(number);
    std::size_t next = tape.uniform_count();
    for (const graph::VariableId id : tape.variables) {
        registers[next++] = rounded(point[index(id)]);
    }
    for (const auto& it : std::span(tape.instructions).subspan(tape.independent)) {
        std::array<double, 4> a;
        for (std::size_t i = 0; i < 4; ++i) a[i] = registers[it.arguments[i]];
        registers[it.result] = rounded(eval::apply<double>(it.op, a[0], a[1], a[2], a[3]));
    }
    return registers[tape.roots[0]];
}

std::vector<double> with_origin(const field::Field& field, const std::array<double, 3>& origin) {
    std::vector<double> parameters(field.graph.parameter_count(), 0.5);
    std::copy(origin.begin(), origin.end(), parameters.end() - 3);
    return parameters;
}

TEST(Recentre, keeps_the_values_of_random_expressions) {
    Random random(seed);
    std::uniform_real_distribution<double> place(-2, 2);
    int compared = 0;
    for (int i = 0; i < 500; ++i) {
        const eval::RandomExpression e = eval::random_expression(random, 2 + i % 10);
        const field::Field world = field_of(e.graph, e.root);
        field::Field about = world;
        recentre(about);
        for (int k = 0; k < 20; ++k) {
            std::array<double, 3> origin, point, here;
            for (std::size_t c = 0; c < 3; ++c) {
                origin[c] = place(random);
                here[c] = place(random);
                point[c] = origin[c] + here[c];
            }
            std::vector<double> parameters(world.graph.parameter_count(), 0.5);
            const double expected = value_at<double>(world, point, parameters);
            // A little off the point where the expression is not steep nothing may change much.
            std::array<double, 3> beside = point;
            for (double& c : beside) c += 1e-9;
            const double near = value_at<double>(world, beside, parameters);
            if (!(std::abs(near - expected) < 1e-4) || std::abs(expected) > 1e3) continue;
            const double found = value_at<double>(about, here, with_origin(about, origin));
            ++compared;
            EXPECT_NEAR(found, expected, 1e-3)
                << "seed " << seed << "\n"
                << graph::print(world.graph, std::array{value_node(world)});
        }
    }
    EXPECT_GT(compared, 4000);
}

/// The error of single precision at points about an origin on the surface, in parts of `scale`.
template <class Build>
double worst_error(Build build, const std::array<double, 3>& origin, double scale) {
    const field::Field world = field_of(build);
    field::Field about = world;
    recentre(about);
    Random random(seed);
    std::uniform_real_distribution<double> place(-scale, scale);
    double worst = 0;
    for (int k = 0; k < 200; ++k) {
        std::array<double, 3> here;
        for (double& c : here) c = static_cast<float>(place(random));
        const double exact = value_at<double>(about, here, with_origin(about, origin));
        const double found = value_at<float>(about, here, with_origin(about, origin));
        worst = std::max(worst, std::abs(found - exact));
    }
    return worst / scale;
}

TEST(Recentre, leaves_errors_in_proportion_to_the_way_from_the_origin) {
    const auto sphere_far_off = [](auto x, auto y, auto z) {
        using analysis::squared;
        return squared(x - 1e4) + squared(y) + squared(z) - 1.0;
    };
    const auto planet = [](auto x, auto y, auto z) {
        using analysis::squared;
        return squared(x) + squared(y + 1e4) + squared(z) - 1e8;
    };
    const auto ball = [](auto x, auto y, auto z) { return hypot(x, y + 1e3, z) - 1e3; };
    const auto box = [](auto x, auto y, auto z) {
        return max(max(abs(x - 1e4) - 1.0, abs(y) - 1.0), abs(z) - 1.0);
    };
    EXPECT_LT(worst_error(sphere_far_off, {1e4, 0, 1}, 1e-4), 1e-5);
    EXPECT_LT(worst_error(planet, {0, 0, 0}, 1e-3) / 2e4, 1e-6);
    EXPECT_LT(worst_error(ball, {0, 0, 0}, 1e-3), 1e-5);
    EXPECT_LT(worst_error(box, {10001, 0.25, 0.5}, 1e-4), 1e-5);
    EXPECT_LT(worst_error(analysis::gyroid, {1e4 * std::numbers::pi, 0, 0}, 1e-4), 1e-5);
    EXPECT_LT(worst_error(analysis::torus, {1.5, 0, 0}, 1e-4), 1e-4);
}

}  // namespace
}  // namespace passes
