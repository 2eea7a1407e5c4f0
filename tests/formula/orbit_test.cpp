// SPDX-License-Identifier: MIT
// The growth of an iteration's state, held against differences of the values: here the state is the
// point itself.
#include "formula/orbit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "eval/tape.h"
#include "formula/understood.h"

namespace formula {
namespace {

constexpr unsigned seed = 7;

/// An expression of the state q, whose stretch, degree and scale are 1.
struct Orbiting {
    std::string text;
    Program program;
    Source source{program, text};
    Scope scope{};
    Lowering lowering{&source, &scope};
    Value value;

    Orbiting(std::string expression, Algebra algebra)
        : text(std::move(expression)), program(*parse(text)) {
        graph::Graph& graph = lowering.field.graph;
        std::vector<graph::NodeId> parts{graph.variable(graph::variable_x),
                                         graph.variable(graph::variable_y),
                                         graph.variable(graph::variable_z)};
        if (algebra == Algebra::complex) parts.pop_back();
        if (algebra == Algebra::quaternion) parts.push_back(graph.constant(0.3));
        const graph::NodeId one = graph.constant(1);
        scope.set("q", VectorValue{algebra, parts, Orbit{one, one, one}}, {}, Role::state);
        scope.set("k", graph.parameter(graph.new_parameter("k")), {}, Role::slider);
        value = lower_expression(lowering, program.result);
        EXPECT_TRUE(lowering.errors.empty()) << text;
    }

    const VectorValue& vector() const { return std::get<VectorValue>(value); }
    double at(graph::NodeId node, glm::dvec3 point) const {
        return eval::evaluate(lowering.field.graph, node, point, std::array{0.0, -1.7});
    }
};

/// How much the value changes along a direction, per unit of it.
double change(const Orbiting& it, glm::dvec3 point, glm::dvec3 direction) {
    constexpr double step = 1e-6;
    double square = 0;
    for (const graph::NodeId part : it.vector().components) {
        const double difference =
            it.at(part, point + step * direction) - it.at(part, point - step * direction);
        square += difference * difference;
    }
    return std::sqrt(square) / (2 * step);
}

/// The stretch, with what it leaves out, bounds every change; `exact`: and some direction reaches
/// it.
void check(const char* expression, Algebra algebra, double degree, double scale, bool exact) {
    const Orbiting it(expression, algebra);
    const std::optional<Orbit> orbit = it.vector().orbit;
    ASSERT_TRUE(orbit) << expression;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-1.3, 1.3);
    const auto draw = [&] {
        return glm::dvec3(coordinate(random), coordinate(random), coordinate(random));
    };
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 point = draw();
        const double stretch = it.at(orbit->across.value_or(orbit->stretch), point);
        double most = 0;
        for (int j = 0; j < 20; ++j) {
            glm::dvec3 direction = draw();
            if (algebra == Algebra::complex) direction.z = 0;
            direction /= std::sqrt(direction.x * direction.x + direction.y * direction.y +
                                   direction.z * direction.z);
            most = std::max(most, change(it, point, direction));
        }
        EXPECT_LE(most, stretch * (1 + 1e-6) + 1e-6) << expression << " seed " << seed;
        if (exact) {
            EXPECT_GE(most, stretch * 0.5) << expression << " seed " << seed;
        }
    }
    EXPECT_DOUBLE_EQ(it.at(orbit->degree, {}), degree) << expression;
    EXPECT_NEAR(it.at(orbit->scale, {}), scale, 1e-12) << expression;
}

TEST(Orbit, of_powers_and_products_bounds_the_derivative) {
    check("q^2 + (1, 2)", Algebra::complex, 2, 1, true);
    check("q^5 - 1", Algebra::complex, 5, 1, true);
    check("2q*q*q", Algebra::complex, 3, 2, true);
    check("3q + q/2", Algebra::complex, 1, 3.5, true);
    check("q^2 + (1, 2, 3, 4)", Algebra::quaternion, 2, 1, true);
    check("conj(q^3)*quaternion(0, 3, 4, 0) + q", Algebra::quaternion, 3, 5, false);
    check("q^2 + q^3", Algebra::quaternion, 3, 1, false);
    check("(2q)^3", Algebra::quaternion, 3, 8, true);
}

TEST(Orbit, of_triplex_powers_counts_the_stretch_around_the_axis) {
    check("q^8", Algebra::triplex, 8, 1, true);
    check("q^2.5", Algebra::triplex, 2.5, 1, true);
    check("2*q^3 + (1, 2, 3)", Algebra::triplex, 3, 2, true);
    check("(q/2)^3 - (x, y, z)", Algebra::triplex, 3, 0.125, false);
    check("triplex(abs(q))^4", Algebra::triplex, 4, 1, true);
    const Orbiting it("q^8", Algebra::triplex);
    const Orbit orbit = *it.vector().orbit;
    ASSERT_TRUE(orbit.across);
    const glm::dvec3 beside_the_axis{1e-3, 0, 1}, around{0, 1, 0};
    EXPECT_GT(change(it, beside_the_axis, around), 7.9 * it.at(orbit.stretch, beside_the_axis));
    EXPECT_FALSE(Orbiting("q^2", Algebra::quaternion).vector().orbit->across);
}

TEST(Orbit, of_folds_keeps_lengths) {
    check("boxfold(q)", Algebra::vector, 1, 1, true);
    check("abs(q)", Algebra::vector, 1, 1, true);
    check("turn(q, (1, 2, 3), 40)", Algebra::vector, 1, 1, true);
    check("reflect(q, (1, 2, 3))", Algebra::vector, 1, 1, true);
    check("q.zxy", Algebra::vector, 1, 1, true);
    check("-q", Algebra::vector, 1, 1, true);
    check("if(q.x < q.y, q.yxz, q)", Algebra::vector, 1, 1, true);
    check("if(dot(q, (1, 1, 1)) < 0, reflect(q, (1, 1, 1)), q)", Algebra::vector, 1, 1, true);
    check("spherefold(q)", Algebra::vector, 1, 1, true);
    check("spherefold(boxfold(q))*-1.7 + (x, y, z)", Algebra::vector, 1, 1.7, false);
    check("k*q + (x, y, z)", Algebra::vector, 1, 1.7, false);
    check("q/k", Algebra::vector, 1, 1 / 1.7, true);
}

TEST(Orbit, is_lost_where_no_rule_tells) {
    for (const char* expression :
         {"(q.x, q.y, q.z)", "q*q.x", "q/length(q)", "sin(q)", "cross(q, (1, 2, 3))", "q.xxz",
          "mod(q, 2)", "reflect(q, q)", "turn(q, (0, 0, 1), x)", "boxfold(q, x)", "q + (x*y, y, z)",
          "if(x < 0, q, (1, 2, 3))", "normalize(q)"}) {
        EXPECT_FALSE(Orbiting(expression, Algebra::vector).vector().orbit) << expression;
    }
    for (const char* expression :
         {"q/q", "inverse(q)", "q^-1", "q^x", "q*quaternion(x, x, y, z)"}) {
        EXPECT_FALSE(Orbiting(expression, Algebra::quaternion).vector().orbit) << expression;
    }
}

TEST(Orbit, of_the_point_and_of_constants_is_known_without_a_rule) {
    const auto known = [](const char* expression) {
        Orbiting it(expression, Algebra::vector);
        const std::optional<Orbit> orbit = orbit_of(it.lowering, it.vector());
        return orbit ? it.at(orbit->stretch, {}) : -1;
    };
    EXPECT_EQ(known("(1, 2, 3)"), 0);
    EXPECT_EQ(known("(k, t, 3)"), 0);
    EXPECT_EQ(known("quaternion(x, y, z, k)"), 1);
    EXPECT_EQ(known("(z, x)"), 1);
    EXPECT_EQ(known("(x, x)"), -1);
    EXPECT_EQ(known("(2x, y)"), -1);
}

}  // namespace
}  // namespace formula
