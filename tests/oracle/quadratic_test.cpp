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

#include "oracle/quaternion.h"
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

/// A slice of the set of q -> q^2 + c in the quaternions.
struct QuaternionSet {
    Wide c;
    double slice;
    int turns;

    std::string formula() const {
        return fmt::format("julia(c = ({}, {}, {}, {}), iterations = {}, slice = {})",
                           static_cast<double>(c[0]), static_cast<double>(c[1]),
                           static_cast<double>(c[2]), static_cast<double>(c[3]), turns, slice);
    }
    Wide next(const Wide& q) const {
        Wide result = anti_commutator(q, q);
        for (std::size_t k = 0; k < 4; ++k) result[k] = result[k] / 2 + c[k];
        return result;
    }
    bool contains(glm::dvec3 p) const {
        Wide q{p.x, p.y, p.z, slice};
        for (int turn = 0; turn <= turns; ++turn, q = next(q)) {
            if (length(q) > 4) return false;
        }
        return true;
    }
    /// The formula of docs/numerics.md, with the radius of each turn, at the first turn that is
    /// outside by half of 1 or by the end; 0 inside.
    double proven_distance(glm::dvec3 p) const {
        const long double settled = 0.5L + std::sqrt(0.25L + length(c));
        Wide q{p.x, p.y, p.z, slice};
        long double derivative = 1, bend = 0;
        for (int turn = 0; turn <= turns; ++turn, q = next(q)) {
            const long double excess = (4 - settled) * std::pow(2 * settled, turn - turns);
            const long double v = length(q) - settled - excess;
            if (turn == turns ? v > 0 : v > std::max(0.5L - excess, 0.0L)) {
                return static_cast<double>(v / (derivative + bend * v));
            }
            bend += derivative / (2 * length(q));
            derivative *= 2 * length(q);
        }
        return 0;
    }
    /// That of the tracers, which is heuristic.
    double estimate(glm::dvec3 p) const {
        Wide q{p.x, p.y, p.z, slice};
        long double derivative = 1;
        int turn = 0;
        for (; length(q) <= 4; ++turn, q = next(q)) derivative *= 2 * length(q);
        const long double size = std::log(length(q)) - std::log(4.0L) * std::exp2(turn - turns);
        return static_cast<double>(0.5L * length(q) * size / derivative);
    }
};

TEST(Quadratic, bounds_of_the_distance_hold_for_any_quaternion) {
    constexpr std::uint64_t seed = 47;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(-0.6, 0.6), place(-1.5, 1.5), unit(-1, 1);
    int reached = 0, outside = 0;
    double logarithms = 0;  // of parts of the estimate
    for (int i = 0; i < 30; ++i) {
        QuaternionSet set{{}, std::round(part(random) * 100) / 100, 3 + i};
        for (long double& each : set.c) each = std::round(part(random) * 1000) / 1000;
        const std::string where = set.formula() + ", seed " + std::to_string(seed);
        const Shape shape = make_shape(understood(set.formula()).field, {});
        Values<numeric::Interval> values(shape);
        for (int k = 0; k < 20; ++k) {
            const glm::dvec3 p{place(random), place(random), place(random)};
            const double reach = proven_reach(values, p), step = set.proven_distance(p);
            if (set.contains(p)) {
                EXPECT_EQ(std::max(reach, step), 0) << where;
                continue;
            }
            ++outside;
            logarithms += std::log(step / set.estimate(p));
            // No point of the box is inside; some twice as far often are.
            for (int sample = 0; sample < 400; ++sample) {
                const glm::dvec3 way{unit(random), unit(random), unit(random)};
                EXPECT_FALSE(set.contains(p + reach * way)) << where;
                EXPECT_FALSE(set.contains(p + step * glm::normalize(way))) << where;
                reached += set.contains(p + 4 * reach * way);
            }
        }
    }
    EXPECT_GT(reached, 100);
    EXPECT_GT(std::exp(logarithms / outside), 0.5);
    RecordProperty("part_of_estimate", std::to_string(std::exp(logarithms / outside)));
}

}  // namespace
}  // namespace oracle
