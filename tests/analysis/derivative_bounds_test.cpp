// SPDX-License-Identifier: MIT
// Bounds of derivatives against known suprema and against derivatives at sampled points.
#include "analysis/derivative_bounds.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "analysis/formulas.h"
#include "analysis/spectral_norm.h"
#include "analysis/symbolic_derivatives.h"
#include "eval/random_expression.h"

namespace analysis {
namespace {

using graph::Expr;
using numeric::infinity;

const Region ball{.centre = glm::dvec3(0), .half = glm::dvec3(2), .sphere = true};
const Region right_box{.centre = {2, 0, 0}, .half = glm::dvec3(1), .sphere = false};
constexpr std::array no_parameters{0.0};
constexpr Effort effort{};

double lipschitz(const Formula& f, const Region& region = ball) {
    return gradient_bound(tape_of(f), region, no_parameters, effort);
}
double curvature(const Formula& f, const Region& region = ball) {
    return second_derivative_bound(tape_of(f), region, no_parameters, effort);
}
bool breaks(const Formula& f, const Region& region = ball) {
    return may_break(tape_of(f), region, no_parameters, effort);
}

/// The largest norms of gradient and Hessian at many points, half of them on the sphere.
struct Sampled {
    double gradient = 0, second = 0;
};
Sampled sample(const eval::Tape& tape, const Region& region, std::span<const double> parameters,
               unsigned points) {
    std::vector<double> registers, v(tape.roots.size());
    eval::load_parameters<double>(tape, parameters, registers);
    Sampled most;
    for (unsigned i = 0; i < points; ++i) {
        glm::dvec3 p = spread_point(region, i);
        if (region.sphere && i % 2 == 0) p *= region.half.x / glm::length(p);
        eval::evaluate_loaded<double>(tape, std::array{p.x, p.y, p.z}, v, registers);
        if (!std::ranges::all_of(v, [](double number) { return std::isfinite(number); })) continue;
        // Directions that are tried stay below the spectral norm.
        const Symmetric<double> h{v[4], v[5], v[6], v[7], v[8], v[9]};
        const glm::dvec3 d = glm::normalize(spread_point(ball, i * 7 + 3));
        const double along = h.xx * d.x * d.x + h.yy * d.y * d.y + h.zz * d.z * d.z +
                             2 * (h.xy * d.x * d.y + h.xz * d.x * d.z + h.yz * d.y * d.z);
        most.gradient = std::max(most.gradient, numeric::hypot3(v[1], v[2], v[3]));
        most.second = std::max(most.second, std::abs(along));
    }
    return most;
}
Sampled sample(const Formula& f, const Region& region) {
    return sample(symbolic_derivatives(f.graph, f.value), region, no_parameters, 20000);
}

/// The bounds hold for sampled derivatives, and are not more than these factors above them.
void check(const Formula& f, double gradient_factor, double second_factor) {
    const Sampled most = sample(f, ball);
    const double gradient = lipschitz(f), second = curvature(f);
    EXPECT_GE(gradient, most.gradient);
    EXPECT_LE(gradient, most.gradient * gradient_factor);
    EXPECT_GE(second, most.second);
    EXPECT_LE(second, most.second * second_factor);
    EXPECT_FALSE(breaks(f));
}

TEST(DerivativeBounds, are_those_of_a_quadratic) {
    const Formula f([](Expr x, Expr y, Expr z) { return squared(x) + squared(y) + squared(z); });
    EXPECT_GE(lipschitz(f), 4);
    EXPECT_LE(lipschitz(f), 4.6) << "large everywhere on the sphere, where the effort runs out";
    EXPECT_GE(curvature(f), 2);
    EXPECT_LE(curvature(f), 2 * 1.02);
}

TEST(DerivativeBounds, hold_for_sampled_points_of_polynomials) {
    check(Formula(torus), 1.2, 1.4);
    check(Formula(barth_sextic), 1.5, 1.6);
    check(Formula([](Expr x, Expr y, Expr z) {
              return squared(squared(x) + squared(y) + squared(z) - 1.0);
          }),
          1.5, 1.5);
}

TEST(DerivativeBounds, hold_for_sampled_points_of_trigonometric_functions) {
    check(Formula(gyroid), 1.2, 1.5);
}

TEST(DerivativeBounds, hold_for_sampled_points_of_random_expressions) {
    constexpr unsigned seed = 161803;
    eval::Random random(seed);
    int first_order = 0, second_order = 0;
    for (int i = 0; i < 400; ++i) {
        const eval::RandomExpression e = eval::random_expression(random, 6);
        const std::array parameters{0.0, eval::ordinary_number(random)};
        const eval::Tape f = eval::make_tape(e.graph, std::array{e.root});
        const Effort little{.cells = 100};
        const double gradient = gradient_bound(f, ball, parameters, little);
        const double second = second_derivative_bound(f, ball, parameters, little);
        const Sampled most = sample(symbolic_derivatives(e.graph, e.root), ball, parameters, 200);
        // Symbolic derivatives at a point have rounding errors of their own.
        EXPECT_GE(gradient * (1 + 1e-9), most.gradient) << "expression " << i << ", seed " << seed;
        EXPECT_GE(second * (1 + 1e-9), most.second) << "expression " << i << ", seed " << seed;
        first_order += gradient < infinity && gradient > 0;
        second_order += second < infinity && second > 0;
    }
    EXPECT_GT(first_order, 100);
    EXPECT_GT(second_order, 50);
}

TEST(DerivativeBounds, of_a_function_with_a_kink_are_first_order_only) {
    const Formula f([](Expr x, Expr y, Expr) { return abs(x) + y; });
    EXPECT_NEAR(lipschitz(f), std::sqrt(2.0), 1e-9);
    EXPECT_EQ(curvature(f), infinity);
    EXPECT_FALSE(breaks(f));
    EXPECT_EQ(curvature(f, right_box), 0) << "without the kink the function is linear";
}

TEST(DerivativeBounds, of_minimum_and_length_are_first_order_at_their_kinks) {
    const Formula f([](Expr x, Expr y, Expr z) { return min(hypot(x, y, z) - 1.0, z); });
    EXPECT_GE(lipschitz(f), 1);
    EXPECT_LE(lipschitz(f), 1.8);
    EXPECT_EQ(curvature(f), infinity);
    const Formula length([](Expr x, Expr y, Expr z) { return hypot(x, y, z); });
    EXPECT_EQ(curvature(length), infinity);
    // 1 / r, and the box is at least 1 away from the origin.
    EXPECT_GE(curvature(length, right_box), 1);
    EXPECT_LE(curvature(length, right_box), 1.2);
}

TEST(DerivativeBounds, are_infinite_at_a_pole) {
    const Formula f([](Expr x, Expr, Expr) { return 1.0 / x; });
    EXPECT_EQ(lipschitz(f), infinity);
    EXPECT_EQ(curvature(f), infinity);
    EXPECT_TRUE(breaks(f));
    // Over [1, 3] the derivatives are -1 / x^2 and 2 / x^3.
    EXPECT_NEAR(lipschitz(f, right_box), 1, 0.06);
    EXPECT_NEAR(curvature(f, right_box), 2, 0.15);
    EXPECT_FALSE(breaks(f, right_box));
}

TEST(DerivativeBounds, are_infinite_at_the_edge_of_a_root) {
    const Formula f([](Expr x, Expr, Expr) { return sqrt(x); });
    EXPECT_EQ(lipschitz(f), infinity);
    EXPECT_EQ(curvature(f), infinity);
    EXPECT_TRUE(breaks(f));
    EXPECT_NEAR(lipschitz(f, right_box), 0.5, 0.03);
    EXPECT_NEAR(curvature(f, right_box), 0.25, 0.02);
}

TEST(DerivativeBounds, take_a_false_alarm_back_by_looking_closer) {
    // Positive everywhere, which intervals do not see at once.
    const Formula f([](Expr x, Expr, Expr) { return sqrt(squared(x) - 2.0 * x + 1.5); });
    EXPECT_TRUE(eval::enclose(f.graph, f.value, bounding_cell(ball).sides()).partial);
    EXPECT_FALSE(breaks(f));
    EXPECT_LT(lipschitz(f), infinity);
}

TEST(DerivativeBounds, report_jumps_as_breaks) {
    const Formula f([](Expr x, Expr y, Expr) { return floor(x + 0.5) + y; });
    EXPECT_TRUE(breaks(f));
    const Formula angle([](Expr x, Expr y, Expr) { return atan2(y, x); });
    EXPECT_TRUE(breaks(angle));
    EXPECT_FALSE(breaks(angle, right_box));
}

TEST(DerivativeBounds, do_not_trust_a_gradient_that_is_undefined_where_the_function_is_not) {
    // For x < 0 the chain rule gives 0 / 0, while the function is y there.
    const Formula f([](Expr x, Expr y, Expr) { return sqrt(max(x, 0.0)) + y; });
    const Region left{.centre = {-2, 0, 0}, .half = glm::dvec3(1), .sphere = false};
    EXPECT_GE(lipschitz(f, left), 1);
}

TEST(DerivativeBounds, follow_the_parameters) {
    Formula f([](Expr x, Expr, Expr) {
        return Expr(*x.graph, x.graph->parameter(x.graph->new_parameter("k"))) * squared(x);
    });
    const eval::Tape tape = tape_of(f);
    for (const double k : {0.5, 3.0}) {
        const std::array parameters{0.0, k};
        EXPECT_NEAR(gradient_bound(tape, ball, parameters, effort), 4 * k, 0.2 * k);
        EXPECT_NEAR(second_derivative_bound(tape, ball, parameters, effort), 2 * k, 0.04 * k);
    }
}

TEST(DerivativeBounds, get_no_worse_with_more_effort) {
    const Formula f(barth_sextic);
    const eval::Tape tape = tape_of(f);
    double before = infinity;
    for (const int cells : {1, 10, 100, 1000}) {
        const double bound =
            second_derivative_bound(tape, ball, no_parameters, Effort{.cells = cells});
        EXPECT_LE(bound, before * (1 + 1e-9));
        before = bound;
    }
    EXPECT_LT(before, 3500);
    EXPECT_GT(before, 1750);
}

}  // namespace
}  // namespace analysis
