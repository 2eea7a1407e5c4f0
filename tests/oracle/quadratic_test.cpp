// SPDX-License-Identifier: MIT
// Proofs about q -> q^2 + c: which iterations are known as such, and whether bounds of the distance
// hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include <fmt/format.h>
#include <quadmath.h>
#include <glm/geometric.hpp>

#include "oracle/quaternion_jet.h"
#include "oracle/ray.h"
#include "oracle/traced.h"
#include "oracle/values.h"

namespace oracle {
namespace {

bool is_proven(const std::string& formula) {
    return !is_heuristic(make_shape(understood(formula).field, {}));
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

std::size_t estimated_pixels(const Scene& scene) {
    const Reference reference = traced(scene, 2);
    EXPECT_EQ(reference.heuristic, std::ranges::any_of(reference.pixels, &Pixel::estimated));
    return static_cast<std::size_t>(std::ranges::count_if(reference.pixels, &Pixel::estimated));
}

TEST(Quadratic, is_proven_at_every_pixel_of_the_whole_set) {
    for (const char* formula :
         {"julia(iterations = 12)", "julia(c = (-0.125, -0.256, 0.847, 0.0895), iterations = 10)",
          "mandelbrot()", "julia() & box(1, 1, 0.5) | sphere(0.3)"}) {
        EXPECT_EQ(estimated_pixels({.formula = formula}), 0U) << formula;
    }
}

template <class Number>
std::array<Number, 4> anti_commutator(const std::array<Number, 4>& a,
                                      const std::array<Number, 4>& b) {
    std::array<Number, 4> result{2 * (a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3])};
    for (std::size_t i = 1; i < 4; ++i) result[i] = 2 * (a[0] * b[i] + b[0] * a[i]);
    return result;
}

long double length(const Wide& a) {
    return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + a[3] * a[3]);
}

using Exact = std::array<__float128, 4>;

__float128 length(const Exact& a) {
    return sqrtq(a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + a[3] * a[3]);
}

/// Of a Julia set, in 113 bits.
bool is_inside(Exact q, const Exact& c, int turns) {
    for (int turn = 0; turn <= turns; ++turn) {
        if (length(q) > 4) return false;
        q = anti_commutator(q, q);
        for (std::size_t i = 0; i < 4; ++i) q[i] = q[i] / 2 + c[i];
    }
    return true;
}

TEST(Quadratic, is_proven_rightly_and_nearly_everywhere_in_a_zoom) {
    const Exact c{-1, 0.2, 0, 0};
    Scene scene{.formula = "julia((-1, 0.2, 0, 0), 60)", .width = 12, .height = 9};
    scene.camera.target = {0.30894811202918104, 0.2074338161473197, 0.017620897534387225};
    for (const double distance : {1e-2, 1e-5}) {
        scene.camera.eye =
            scene.camera.target + distance * glm::normalize(glm::dvec3(0.424, 0.352, 0.835));
        const Reference reference = traced(scene, 2);
        const Pinhole pinhole(scene.camera, scene.width, scene.height);
        int proven = 0;
        for (int i = 0; i < scene.width * scene.height; ++i) {
            const Pixel& pixel = reference.pixels[static_cast<std::size_t>(i)];
            const Ray ray = pinhole.through(i % scene.width + 0.5, i / scene.width + 0.5);
            const auto place = [&](double t) {
                Exact q{};
                for (int k = 0; k < 3; ++k) {
                    q[static_cast<std::size_t>(k)] =
                        __float128(ray.origin[k]) + __float128(t) * __float128(ray.direction[k]);
                }
                return q;
            };
            if (pixel.estimated || pixel.verdict != Verdict::hit) continue;
            ++proven;
            EXPECT_TRUE(is_inside(place(pixel.far), c, 60)) << i << " from " << distance;
            double way = pixel.near;  // to be gone
            for (int sample = 0; sample < 60; ++sample, way *= 0.8) {
                EXPECT_FALSE(is_inside(place(pixel.near - way), c, 60))
                    << i << " from " << distance << " at " << sample;
            }
        }
        EXPECT_GE(proven, 95) << distance;
    }
}

/// With a radius, or so small a one that only the rounding of the results counts.
template <class Real>
QuaternionBall<Real> random_ball(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const double size = std::exp2(8 * normal(random));
    std::array<Real, 4> centre;
    for (Real& each : centre)
        each = static_cast<Real>(size) / 3 * static_cast<Real>(normal(random));
    const double part = std::exp2(-10 * std::abs(normal(random)));
    return {centre, random() % 2 == 0 ? 0 : size * part};
}

/// On the ball's edge.
template <class Real>
Exact random_member(const QuaternionBall<Real>& of, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const __float128 tiny = 0x1p-100;
    Exact way, result;
    for (__float128& each : way) each = normal(random);
    const __float128 part = of.radius * (1 - tiny) / length(way);
    for (std::size_t i = 0; i < 4; ++i) result[i] = of.centre[i] + part * way[i];
    return result;
}

template <class Real>
void expect_in(const Exact& exact, const QuaternionBall<Real>& result) {
    Exact off;
    for (std::size_t i = 0; i < 4; ++i) off[i] = exact[i] - result.centre[i];
    EXPECT_TRUE(length(off) <= result.radius);
}

template <class Real>
void expect_results_of_members_in_balls() {
    std::mt19937_64 random(20261122);
    for (int i = 0; i < 20'000; ++i) {
        const QuaternionBall<Real> a = random_ball<Real>(random), b = random_ball<Real>(random);
        const QuaternionBall<double> c = random_ball<double>(random);
        const Exact p = random_member(a, random), q = random_member(b, random),
                    r = random_member(c, random);
        Exact total, half = anti_commutator(p, p);
        __float128 inner = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            total[k] = p[k] + q[k];
            half[k] /= 2;
            inner += p[k] * r[k];
        }
        expect_in(total, sum(a, b));
        expect_in(half, square(a));
        expect_in(anti_commutator(p, r), products(a, c));
        const numeric::Interval products_of_members = inner_product(a, c), norms = norm(a);
        EXPECT_TRUE(products_of_members.lo <= inner && inner <= products_of_members.hi);
        const __float128 exact = length(p) * length(p);
        EXPECT_TRUE(norms.lo <= exact && exact <= norms.hi);
        // And no larger than the products of the ball itself.
        constexpr double rounding = 10 * static_cast<double>(std::numeric_limits<Real>::epsilon());
        EXPECT_LE(square(a).radius,
                  (2 * a.length + a.radius) * a.radius * (1 + 1e-14) + rounding * norms.hi);
    }
}

TEST(QuaternionBall, holds_the_results_of_members) {
    expect_results_of_members_in_balls<double>();
    expect_results_of_members_in_balls<long double>();
}

TEST(QuaternionBall, adds_nothing_to_nothing) {
    const QuaternionBall<double> a{{1, 2, 3, 4}, 0.5}, nothing{};
    EXPECT_EQ(sum(a, nothing).centre, a.centre);
    EXPECT_GE(sum(a, nothing).radius, 0.5);
    EXPECT_LE(sum(a, nothing).radius, 0.5 + 1e-14);
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
