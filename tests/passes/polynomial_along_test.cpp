// SPDX-License-Identifier: MIT
// Coefficients along rays against the formula's values at points of the rays.
#include "passes/polynomial_along.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>

#include "eval/tape.h"
#include "passes/operation_count.h"
#include "passes/rule.h"

namespace passes {
namespace {

using graph::NodeId;
using Random = std::mt19937_64;

/// A graph with a ray of variables: the point c and the vector e.
struct Ray : Leaves {
    std::array<NodeId, 3> c, e;

    Ray() {
        for (NodeId& it : c) it = graph.variable(graph.new_variable("c"));
        for (NodeId& it : e) it = graph.variable(graph.new_variable("e"));
    }
    std::optional<std::vector<NodeId>> along(Expr f, std::size_t largest_degree = 12) {
        return polynomial_along(graph, f.id, c, e, largest_degree);
    }
};

/// An expression of a degree from 0 to `degree`, with the parameter among its coefficients, and
/// with absolute values in place of all terms: how large its terms are.
Expr random_polynomial(Ray& ray, Random& random, int degree) {
    const auto number = [&] {
        return ray.number(std::uniform_int_distribution(-8, 8)(random) / 4.0);
    };
    if (degree == 0) return random() % 3 == 0 ? ray.t * number() : number();
    if (degree == 1 || random() % 8 == 0) {
        return std::array{ray.x, ray.y, ray.z}[random() % 3] + number();
    }
    const int part = std::uniform_int_distribution(0, degree)(random);
    switch (random() % 6) {
        case 0:
            return random_polynomial(ray, random, degree) - random_polynomial(ray, random, part);
        case 1: {
            const Expr half = random_polynomial(ray, random, degree / 2);
            return half * half;
        }
        case 2:
            return pow(random_polynomial(ray, random, degree / 3), ray.number(3));
        case 3:
            return -random_polynomial(ray, random, degree) / (ray.t + 2.0);
        default:
            return random_polynomial(ray, random, part) *
                   random_polynomial(ray, random, degree - part);
    }
}

TEST(PolynomialAlong, has_the_formulas_values_along_random_rays) {
    constexpr std::uint64_t seed = 20261122;
    Random random(seed);
    std::uniform_real_distribution<double> real(-1, 1);
    int checked = 0;
    for (int round = 0; round < 400; ++round) {
        Ray ray;
        const Expr f = random_polynomial(ray, random, 2 + round % 11);
        const auto along = ray.along(f);
        ASSERT_TRUE(along) << "seed " << seed << ", round " << round;
        ASSERT_LE(along->size(), 13U);
        const eval::Tape tape = eval::make_tape(ray.graph, *along);
        std::vector<double> a(along->size()), scratch;
        for (int k = 0; k < 8; ++k) {
            std::vector<double> variables(ray.graph.variable_count());
            for (double& it : variables) it = real(random);
            const std::array time{real(random)};
            eval::evaluate<double>(tape, variables, time, std::span(a), scratch);
            const double s = real(random);
            double sum = 0, size = 1;
            for (std::size_t i = a.size(); i-- > 0;) {
                sum = sum * s + a[i];
                size += std::abs(a[i]);
            }
            const std::size_t first = variables.size() - 6;
            const glm::dvec3 p(variables[first] + s * variables[first + 3],
                               variables[first + 1] + s * variables[first + 4],
                               variables[first + 2] + s * variables[first + 5]);
            const double value = eval::evaluate(ray.graph, f.id, p, time);
            // Terms may be larger than the coefficients that are left of them.
            EXPECT_NEAR(sum, value, 1e-11 * size) << "seed " << seed << ", round " << round;
            ++checked;
        }
    }
    EXPECT_EQ(checked, 3200);
}

TEST(PolynomialAlong, is_exact_for_whole_numbers) {
    Ray ray;
    const auto along = ray.along(pow(ray.x + ray.y, ray.number(3)) - 2.0 * ray.x * ray.z);
    ASSERT_TRUE(along);
    ASSERT_EQ(along->size(), 4U);
    std::vector<double> variables(ray.graph.variable_count());
    const std::array at{1.0, 2.0, 3.0, 1.0, -3.0, 5.0};
    std::ranges::copy(at, variables.end() - 6);
    std::vector<double> a(4), scratch;
    eval::evaluate<double>(eval::make_tape(ray.graph, *along), variables, std::array{0.0},
                           std::span(a), scratch);
    // (3 - 2 s)^3 - 2 (1 + s) (3 + 5 s)
    EXPECT_EQ(a, (std::vector<double>{27 - 6, -54 - 16, 36 - 10, -8}));
}

TEST(PolynomialAlong, is_none_for_what_is_no_polynomial_or_of_too_high_a_degree) {
    Ray ray;
    EXPECT_FALSE(ray.along(sin(ray.x)));
    EXPECT_FALSE(ray.along(ray.x / ray.y));
    EXPECT_FALSE(ray.along(abs(ray.x) * ray.y));
    EXPECT_FALSE(ray.along(pow(ray.x, ray.t)));
    EXPECT_FALSE(ray.along(pow(ray.x, ray.number(-1))));
    EXPECT_FALSE(ray.along(pow(ray.x, ray.number(4)), 3));
    EXPECT_FALSE(ray.along(ray.x * ray.y * ray.z * ray.x, 3));
    EXPECT_TRUE(ray.along(ray.x * ray.y * ray.z * ray.x, 4));
    EXPECT_TRUE(ray.along(ray.x * sin(ray.t) + exp(ray.t)));
}

TEST(PolynomialAlong, leaves_to_the_frame_what_depends_on_parameters_alone) {
    Ray ray;
    const auto along = ray.along(ray.x * sin(ray.t));
    ASSERT_TRUE(along);
    EXPECT_EQ(count_operations(ray.graph, *along).at_points, 2U);
    EXPECT_EQ(count_operations(ray.graph, *along).hoisted, 1U);
}

TEST(PolynomialAlong, squares_with_fewer_operations_than_it_multiplies) {
    const auto operations = [](bool same) {
        Ray ray;
        const Expr a = ray.x * ray.y + ray.z, b = ray.x * ray.z + ray.y;
        const auto along = ray.along(a * (same ? a : b));
        return along ? count_operations(ray.graph, *along).at_points : 0;
    };
    EXPECT_GT(operations(true), 0U);
    EXPECT_LT(operations(true) + 5, operations(false));
}

}  // namespace
}  // namespace passes
