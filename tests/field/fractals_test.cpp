// SPDX-License-Identifier: MIT
// Escape-time sets against plain iterations, and their estimates against distances found by search.
#include "field/fractals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "field/shapes.h"

namespace field {
namespace {

using glm::dvec3;
using Quaternion = std::array<double, 4>;
using IsInside = std::function<bool(dvec3)>;

constexpr double escape = 4;

Quaternion product(const Quaternion& a, const Quaternion& b) {
    return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

bool is_in_julia(dvec3 p, const Quaternion& c, int iterations, double slice) {
    Quaternion q{p.x, p.y, p.z, slice};
    for (int i = 0; i <= iterations; ++i) {
        double square = 0;
        for (const double part : q) square += part * part;
        if (square > escape * escape) return false;
        q = product(q, q);
        for (std::size_t k = 0; k < 4; ++k) q[k] += c[k];
    }
    return true;
}

/// In spherical coordinates, by angles.
bool is_in_mandelbulb(dvec3 p, double power, int iterations) {
    dvec3 z = p;
    for (int i = 0; i <= iterations; ++i) {
        const double r = glm::length(z);
        if (r > escape) return false;
        const double theta = r == 0 ? 0 : power * std::acos(z.z / r);
        const double phi = power * std::atan2(z.y, z.x);
        const dvec3 turned(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                           std::cos(theta));
        z = std::pow(r, power) * turned + p;
    }
    return true;
}

/// Fails unless both agree on what is inside, up to a few points where rounding decides.
void expect_members(const Field& f, unsigned seed, double size, const IsInside& is_inside) {
    Random random(seed);
    constexpr int points = 1500;
    int inside = 0, different = 0;
    for (int i = 0; i < points; ++i) {
        const dvec3 p = random_point(random, size);
        const bool expected = is_inside(p);
        inside += expected;
        different += (value(f, p) < 0) != expected;
    }
    EXPECT_GT(inside, points / 50);
    EXPECT_LE(different, 2) << "seed " << seed;
}

TEST(Julia, has_the_members_of_the_plain_iteration) {
    const Quaternion c{-0.2, 0.6, 0.2, 0.2};
    expect_members(primitive("julia", {c[0], c[1], c[2], c[3], 11, 0.1}), 41, 1.3,
                   [&](dvec3 p) { return is_in_julia(p, c, 11, 0.1); });
}

TEST(Julia, of_zero_is_a_ball_with_a_known_estimate) {
    const int iterations = 6;
    const Field f = primitive("julia", {0, 0, 0, 0, static_cast<double>(iterations), 0});
    const double radius = std::pow(escape, std::exp2(-iterations));
    for (const double r : {radius * 1.001, 1.1, 1.5, 2.0, 3.9}) {
        const double expected = 0.5 * r * std::log(r / radius);
        EXPECT_NEAR(value(f, {0.6 * r, 0, -0.8 * r}), expected, 1e-12) << r;
    }
    EXPECT_EQ(value(f, {radius * 0.999, 0, 0}), -INFINITY);
}

TEST(Mandelbulb, has_the_members_of_the_plain_iteration) {
    for (const double power : {2.0, 5.0, 8.0}) {
        expect_members(primitive("mandelbulb", {power, 6}), 42, 1.2,
                       [&](dvec3 p) { return is_in_mandelbulb(p, power, 6); });
    }
    expect_members(primitive("mandelbulb", {4.5, 6}), 43, 1.2,
                   [&](dvec3 p) { return is_in_mandelbulb(p, 4.5, 6); });
}

TEST(Mandelbulb, is_the_same_by_multiplication_and_by_angles) {
    constexpr unsigned seed = 44;
    Random random(seed);
    for (const double power : {2.0, 3.0, 8.0, 17.0}) {
        const Field multiplied = primitive("mandelbulb", {power, 4});
        Field angles;
        const graph::NodeId slider = angles.graph.parameter(angles.graph.new_parameter("power"));
        angles.root = mandelbulb(angles, std::array{slider, angles.graph.constant(4)});
        int compared = 0;
        for (int i = 0; i < 300; ++i) {
            const dvec3 p = random_point(random, 1.5);
            const double a = value(multiplied, p);
            const double b = eval::value(angles, angles.root, p, std::array{0.0, power});
            if (std::isinf(a) && a == b) continue;
            ++compared;
            // Errors grow by the power at each of the iterations.
            ASSERT_NEAR(a, b, 1e-13 * std::pow(power, 4) * (1 + std::abs(a)))
                << power << ", seed " << seed << ": " << describe(p);
        }
        EXPECT_GT(compared, 50);
    }
}

TEST(Mandelbulb, has_values_on_its_axis) {
    const Field f = primitive("mandelbulb", {8, 6});
    for (const double z : {-2.0, -1.3, 1.3, 2.0}) {
        EXPECT_TRUE(std::isfinite(value(f, {0, 0, z}))) << z;
    }
    EXPECT_LT(value(f, {0, 0, 0}), 0);
}

/// Points of the set's surface, up to 1e-9: between a point inside and one outside.
std::vector<dvec3> surface_points(const IsInside& is_inside, double size, std::size_t count,
                                  Random& random) {
    std::vector<dvec3> list;
    while (list.size() < count) {
        dvec3 in = random_point(random, size), out = random_point(random, size);
        if (!is_inside(in) || is_inside(out)) continue;
        while (glm::distance(in, out) > 1e-9) {
            const dvec3 middle = 0.5 * (in + out);
            (is_inside(middle) ? in : out) = middle;
        }
        list.push_back(in);
    }
    return list;
}

/// Estimates over the distance from the nearest of many points of the set, which is no less than
/// the distance from the set; in increasing order. From far away and closer and closer to the
/// surface.
std::vector<double> factors(const Field& f, const IsInside& is_inside, unsigned seed) {
    Random random(seed);
    const std::vector<dvec3> surface = surface_points(is_inside, 1.3, 4000, random);
    std::vector<double> list;
    while (list.size() < 2000) {
        const double away = std::exp2(-static_cast<double>(random() % 16));
        const dvec3 p = surface[random() % surface.size()] + away * random_point(random, 1);
        if (is_inside(p)) continue;
        double nearest = INFINITY;
        for (const dvec3& q : surface) nearest = std::min(nearest, glm::distance(p, q));
        list.push_back(value(f, p) / nearest);
    }
    std::ranges::sort(list);
    return list;
}

double part_of(const std::vector<double>& sorted, double part) {
    return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

TEST(Julia, estimates_no_more_than_the_distance) {
    for (const Quaternion& c : {Quaternion{-0.2, 0.6, 0.2, 0.2}, Quaternion{-1, 0.2, 0, 0},
                                Quaternion{-0.125, -0.256, 0.847, 0.0895}}) {
        const Field f = primitive("julia", {c[0], c[1], c[2], c[3], 11, 0});
        const auto list = factors(
            f, [&](dvec3 p) { return is_in_julia(p, c, 11, 0); }, 45);
        EXPECT_GT(list.front(), 0);
        EXPECT_LT(list.back(), 0.85);
        EXPECT_GT(list.back(), 0.5) << "far too careful";
    }
}

/// Heuristic: near the axis the estimate may be too large.
TEST(Mandelbulb, estimates_no_more_than_the_distance_almost_everywhere) {
    for (const double power : {2.0, 3.0, 8.0, 16.0}) {
        const Field f = primitive("mandelbulb", {power, 8});
        const auto list = factors(
            f, [&](dvec3 p) { return is_in_mandelbulb(p, power, 8); }, 46);
        EXPECT_GT(list.front(), 0) << power;
        EXPECT_LT(part_of(list, 0.98), 0.85) << power;
        EXPECT_LT(part_of(list, 0.99), 1) << power;
        EXPECT_LT(part_of(list, 0.998), 3) << power;
        EXPECT_LT(list.back(), 8) << power;
        EXPECT_GT(part_of(list, 0.99), 0.4) << power << ": far too careful";
    }
}

}  // namespace
}  // namespace field
