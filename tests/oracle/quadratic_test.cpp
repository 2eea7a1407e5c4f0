// SPDX-License-Identifier: MIT
// Proofs about q -> q^2 + c: which iterations are known as such, and whether bounds of the distance
// hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "oracle/quaternion_jet.h"
#include "oracle/traced.h"
#include "oracle/values.h"

namespace oracle {
namespace {

bool is_proven(const std::string& formula) {
    return !traced({.formula = formula, .bounds = {}, .width = 2, .height = 2}).heuristic;
}

TEST(Quadratic, is_known_however_it_is_written) {
    for (const char* formula :
         {"julia()", "julia(c = (0.3, 0.5, 0.1, -0.2), iterations = 30, slice = 0.2)",
          "mandelbrot()", "julia() & box(1, 1, 0.5)",
          "complement(julia(iterations = 5)) & sphere(2)",
          "translate(rotate(julia(), (1, 2, 3), 1), (0.1, 0, 0))",
          "param s = 0.3 in [0, 1]\njulia(slice = s)",
          "iterate q = quaternion(x, y, z, 0) for 9 until length(q) > 4:\n    q = q*q + (x, 0.1, "
          "y, z)",
          "iterate q = quaternion(x, y, z, 0) for 9 until length(q) > 4:\n    q = (0.1, 0.2, 0, 0) "
          "- -q^2",
          "iterate q = complex(x, y) for 9 until length(q) > 3:\n    q = q^2 - (0.1, 0.7)"}) {
        EXPECT_TRUE(is_proven(formula)) << formula;
    }
}

TEST(Quadratic, nothing_else_is_taken_for_it) {
    for (const char* formula :
         {"mandelbulb(2, 4)", "mandelbrot(3)", "bicomplex()",
          "smooth_union(julia(iterations = 3), sphere(0.5), 0.1)",
          "iterate q = quaternion(x, y, z, 0) for 4 until length(q) > 4:\n    q = 2q^2 + (0.1, 0, "
          "0, "
          "0)",
          "iterate q = quaternion(x, y, z, 0) for 4 until length(q) > 4:\n    q = q^2 + 0.1q",
          "iterate q = quaternion(x, y, z, 0) for 4 until length(q) > 4:\n    q = if(q.x < 0, -q, "
          "q)^2",
          "iterate q = quaternion(x, y, z, 0) for 4 until length(q) > 4:\n    q = q^2 + "
          "quaternion(abs(q.x), 0, 0, 0)"}) {
        EXPECT_FALSE(is_proven(formula)) << formula;
    }
}

TEST(Quadratic, cuts_a_sheet_with_a_proof_and_an_estimate_cuts_one_without) {
    for (const char* set : {"julia(c = (0, 0, 0, 0))", "mandelbulb(8, 3)"}) {
        const std::string text = std::string("z = 0.1 & ") + set;
        const Pixel within = down_z(text, 0.3, 0.2);
        EXPECT_EQ(within.verdict, Verdict::hit) << text;
        EXPECT_NEAR(within.depth(), 4.9, 1e-8) << text;
        EXPECT_EQ(down_z(text, 1.5, 0.2).verdict, Verdict::miss) << text;
        EXPECT_EQ(is_proven(text), text.find("julia") != std::string::npos);
    }
}

using Wide = std::array<long double, 4>;

Wide anti_commutator(const Wide& a, const Wide& b) {
    Wide result{2 * (a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3])};
    for (std::size_t i = 1; i < 4; ++i) result[i] = 2 * (a[0] * b[i] + b[0] * a[i]);
    return result;
}

long double length(const Wide& a) {
    return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + a[3] * a[3]);
}

TEST(QuaternionBall, holds_the_results_of_members) {
    std::mt19937_64 random(20261122);
    std::normal_distribution<double> normal;
    const auto ball = [&] {
        QuaternionBall result;
        const double size = std::exp2(8 * normal(random));
        for (double& each : result.centre) each = size * normal(random);
        result.radius = size * std::exp2(-10 * std::abs(normal(random)));
        return result;
    };
    const auto member = [&](const QuaternionBall& of) {
        Wide way;
        for (long double& each : way) each = normal(random);
        const long double part = of.radius / length(way);
        Wide result;
        for (std::size_t i = 0; i < 4; ++i) result[i] = of.centre[i] + part * way[i];
        return result;
    };
    const auto expect_in = [](const Wide& exact, const QuaternionBall& result) {
        Wide off;
        for (std::size_t i = 0; i < 4; ++i) off[i] = exact[i] - result.centre[i];
        EXPECT_LE(length(off), static_cast<long double>(result.radius));
    };
    for (int i = 0; i < 20'000; ++i) {
        const QuaternionBall a = ball(), b = ball();
        const Wide p = member(a), q = member(b);
        Wide total, half = anti_commutator(p, p);
        long double inner = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            total[k] = p[k] + q[k];
            half[k] /= 2;
            inner += p[k] * q[k];
        }
        expect_in(total, sum(a, b));
        expect_in(half, square(a));
        expect_in(anti_commutator(p, q), products(a, b));
        const numeric::Interval products_of_members = inner_product(a, b), norms = norm(a);
        EXPECT_TRUE(products_of_members.lo <= inner && inner <= products_of_members.hi);
        const long double exact = length(p) * length(p);
        EXPECT_TRUE(norms.lo <= exact && exact <= norms.hi);
        // And no larger than the products of the ball itself.
        EXPECT_LE(square(a).radius,
                  (2 * centre_length(a) + a.radius) * a.radius + 1e-14 * norms.hi);
    }
}

/// The set of z -> z^2 + c, c real, in the half-plane that it is turned out of: with bounds of the
/// distance by its potential.
struct TurnedSet {
    double c;
    int turns;

    bool contains(std::complex<long double> z) const {
        for (int turn = 0; turn <= turns; ++turn) {
            if (std::norm(z) > 16) return false;
            z = z * z + static_cast<long double>(c);
        }
        return true;
    }
    /// Of the set that is drawn, log|f(z)/4| / 2^turns with f the last turn, and its gradient.
    std::pair<long double, long double> potential(std::complex<long double> z) const {
        std::complex<long double> slope = 1;
        int turn = 0;
        for (; turn < turns && std::norm(z) < 1e60L; ++turn) {
            slope *= 2.0L * z;
            z = z * z + static_cast<long double>(c);
        }
        const long double parts = std::exp2(-static_cast<long double>(turn));
        return {parts * std::log(std::abs(z)) - std::log(4.0L) * std::exp2(-turns),
                parts * std::abs(slope / z)};
    }
    /// Less than `resolution` above the distance, and not below it.
    long double sampled_distance(std::complex<long double> z, long double resolution) const {
        for (long double r = 0;; r += resolution / 2) {
            const int count = 8 + static_cast<int>(2 * std::numbers::pi * r / resolution);
            for (int i = 0; i < count; ++i) {
                const long double angle = 2 * std::numbers::pi_v<long double> * i / count;
                if (contains(z + std::polar(r, angle))) return r;
            }
        }
    }
};

/// The largest half side of a box that is proven to be outside, up to a part of 1/16.
double proven_reach(Values<numeric::Interval>& values, glm::dvec3 point) {
    double reach = 4;
    for (; reach > 1e-9; reach *= 0.9375) {
        std::array<numeric::Interval, 3> box;
        for (std::size_t i = 0; i < 3; ++i) {
            const double at = point[static_cast<int>(i)];
            box[i] = {at - reach, at + reach};
        }
        values.move_to(box);
        if (values.solid(0).lo > 0) return reach;
    }
    return 0;
}

TEST(Quadratic, bounds_of_the_distance_hold_where_c_is_real) {
    constexpr std::uint64_t seed = 31;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(-2, 2), angle(0, 6.3);
    double least_part = 1;
    for (const double c : {-1.0, -0.6, 0.1, 0.24}) {
        const TurnedSet set{c, 11};
        const std::string text = "julia(c = (" + std::to_string(c) + ", 0, 0, 0))";
        const Shape shape = make_shape(understood(text).field, {});
        Values<numeric::Interval> values(shape);
        for (int i = 0; i < 25; ++i) {
            const std::complex<long double> z(place(random), std::abs(place(random)));
            if (set.contains(z)) continue;
            const auto [g, slope] = set.potential(z);
            const long double far = 2 * std::sinh(g) / slope;
            const long double near = far / (4 * std::exp(g));
            const long double resolution = near / 16;
            const long double distance = set.sampled_distance(z, resolution);
            const std::string where =
                text + " from " + std::to_string(static_cast<double>(z.real())) + "," +
                std::to_string(static_cast<double>(z.imag())) + ", seed " + std::to_string(seed);
            EXPECT_LE(near, distance) << where;
            EXPECT_GE(far, distance - 2 * resolution) << where;
            const double turn = angle(random);
            const double reach = proven_reach(
                values, {z.real(), z.imag() * std::cos(turn), z.imag() * std::sin(turn)});
            EXPECT_LE(reach, distance) << where;
            least_part = std::min(least_part, reach / static_cast<double>(distance));
        }
    }
    EXPECT_GT(least_part, 0.05);
    RecordProperty("least_part", std::to_string(least_part));
}

TEST(Quadratic, bounds_of_the_distance_hold_for_any_quaternion) {
    constexpr std::uint64_t seed = 47;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(-0.6, 0.6), place(-1.5, 1.5), unit(-1, 1);
    int reached = 0;
    for (int i = 0; i < 30; ++i) {
        Wide c;
        for (long double& each : c) each = std::round(part(random) * 1000) / 1000;
        const double slice = std::round(part(random) * 100) / 100;
        const std::string text =
            fmt::format("julia(c = ({}, {}, {}, {}), iterations = {}, slice = {})",
                        static_cast<double>(c[0]), static_cast<double>(c[1]),
                        static_cast<double>(c[2]), static_cast<double>(c[3]), 3 + i, slice);
        const Shape shape = make_shape(understood(text).field, {});
        Values<numeric::Interval> values(shape);
        const auto is_inside = [&](glm::dvec3 p) {
            Wide q{p.x, p.y, p.z, slice};
            for (int turn = 0; turn <= 3 + i; ++turn) {
                if (length(q) > 4) return false;
                q = anti_commutator(q, q);
                for (std::size_t k = 0; k < 4; ++k) q[k] = q[k] / 2 + c[k];
            }
            return true;
        };
        // The proven distance of docs/numerics.md, the largest that a turn gives.
        const auto step_by_formula = [&](glm::dvec3 p) {
            Wide q{p.x, p.y, p.z, slice};
            long double derivative = 1, bend = 0, most = 0;
            for (int turn = 0; turn <= 3 + i; ++turn) {
                const long double v = length(q) - 4;
                if (v > 0) most = std::max(most, v / (derivative + bend * v));
                bend += derivative / (2 * length(q));
                derivative *= 2 * length(q);
                q = anti_commutator(q, q);
                for (std::size_t k = 0; k < 4; ++k) q[k] = q[k] / 2 + c[k];
            }
            return static_cast<double>(most);
        };
        for (int k = 0; k < 20; ++k) {
            const glm::dvec3 p{place(random), place(random), place(random)};
            const double reach = proven_reach(values, p);
            const double step = step_by_formula(p);
            if (is_inside(p)) {
                EXPECT_EQ(std::max(reach, step), 0) << text << ", seed " << seed;
                continue;
            }
            // No point of the box is inside; some twice as far often are.
            for (int sample = 0; sample < 400; ++sample) {
                const glm::dvec3 way{unit(random), unit(random), unit(random)};
                EXPECT_FALSE(is_inside(p + reach * way)) << text << ", seed " << seed;
                EXPECT_FALSE(is_inside(p + step * glm::normalize(way)))
                    << text << ", seed " << seed;
                reached += is_inside(p + 4 * reach * way);
            }
        }
    }
    EXPECT_GT(reached, 100);
}

}  // namespace
}  // namespace oracle
