// SPDX-License-Identifier: MIT
// Escape-time sets against plain iterations, and their estimates against distances found by search.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "formula/fractals.h"

namespace formula {
namespace {

using glm::dvec3;
using Quaternion = std::array<double, 4>;

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
void expect_members(const Fractal& fractal, unsigned seed, double size, const IsInside& is_inside) {
    Random random(seed);
    constexpr int points = 1500;
    int inside = 0, different = 0;
    for (int i = 0; i < points; ++i) {
        const dvec3 p = random_point(random, size);
        const bool expected = is_inside(p);
        inside += expected;
        different += (fractal.value(p) < 0) != expected;
    }
    EXPECT_GT(inside, points / 50);
    EXPECT_LE(different, 2) << "seed " << seed;
}

std::string text_of(const Quaternion& c) {
    return fmt::format("({}, {}, {}, {})", c[0], c[1], c[2], c[3]);
}

Fractal julia(const Quaternion& c, int iterations, double slice = 0) {
    return Fractal(
        fmt::format("julia(c = {}, iterations = {}, slice = {})", text_of(c), iterations, slice));
}

/// The same set by a step in components, from which nothing but dual numbers finds the derivative.
Fractal julia_by_components(const Quaternion& c, int iterations) {
    return Fractal(fmt::format(
        "iterate q = quaternion(x, y, z, 0) for {} until length(q) > 4:\n"
        "    q = quaternion(q.x^2 - q.y^2 - q.z^2 - q.w^2, 2q.x*q.y, 2q.x*q.z, 2q.x*q.w) + {}",
        iterations, text_of(c)));
}

Fractal mandelbulb(double power, int iterations) {
    return Fractal(fmt::format("mandelbulb({}, iterations = {})", power, iterations));
}

TEST(Julia, has_the_members_of_the_plain_iteration) {
    const Quaternion c{-0.2, 0.6, 0.2, 0.2};
    expect_members(julia(c, 11, 0.1), 41, 1.3, [&](dvec3 p) { return is_in_julia(p, c, 11, 0.1); });
}

TEST(Julia, of_zero_is_a_ball_with_a_known_estimate) {
    const int iterations = 6;
    const Fractal f = julia({0, 0, 0, 0}, iterations);
    const double radius = std::pow(escape, std::exp2(-iterations));
    for (const double r : {radius * 1.001, 1.1, 1.5, 2.0, 3.9}) {
        const double expected = 0.5 * r * std::log(r / radius);
        EXPECT_NEAR(f.value({0.6 * r, 0, -0.8 * r}), expected, 1e-12) << r;
    }
    EXPECT_EQ(f.value({radius * 0.999, 0, 0}), -INFINITY);
}

TEST(Mandelbulb, has_the_members_of_the_plain_iteration) {
    for (const double power : {2.0, 5.0, 8.0}) {
        expect_members(mandelbulb(power, 6), 42, 1.2,
                       [&](dvec3 p) { return is_in_mandelbulb(p, power, 6); });
    }
    expect_members(mandelbulb(4.5, 6), 43, 1.2,
                   [&](dvec3 p) { return is_in_mandelbulb(p, 4.5, 6); });
}

TEST(Mandelbulb, is_the_same_by_multiplication_and_by_angles) {
    constexpr unsigned seed = 44;
    Random random(seed);
    for (const double power : {2.0, 3.0, 8.0, 17.0}) {
        const Fractal multiplied = mandelbulb(power, 4);
        const Fractal angles(
            fmt::format("param n = {} in [1, 20]\nmandelbulb(n, iterations = 4)", power));
        int compared = 0;
        for (int i = 0; i < 300; ++i) {
            const dvec3 p = random_point(random, 1.5);
            const double a = multiplied.value(p), b = angles.value(p);
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
    const Fractal f = mandelbulb(8, 6);
    for (const double z : {-2.0, -1.3, 1.3, 2.0}) {
        EXPECT_TRUE(std::isfinite(f.value({0, 0, z}))) << z;
    }
    EXPECT_LT(f.value({0, 0, 0}), 0);
}

TEST(Julia, estimates_no_more_than_the_distance) {
    for (const Quaternion& c : {Quaternion{-0.2, 0.6, 0.2, 0.2}, Quaternion{-1, 0.2, 0, 0},
                                Quaternion{-0.125, -0.256, 0.847, 0.0895}}) {
        const auto list = factors(
            julia(c, 11), [&](dvec3 p) { return is_in_julia(p, c, 11, 0); }, 45);
        EXPECT_GT(list.front(), 0);
        EXPECT_LT(list.back(), 0.85);
        EXPECT_GT(list.back(), 0.5) << "far too careful";
    }
}

/// The Frobenius norm is up to sqrt(3) times the stretch.
TEST(Julia, estimates_no_more_than_the_distance_by_dual_numbers) {
    const Quaternion c{-0.2, 0.6, 0.2, 0.2};
    const auto list = factors(
        julia_by_components(c, 11), [&](dvec3 p) { return is_in_julia(p, c, 11, 0); }, 45);
    EXPECT_GT(list.front(), 0);
    EXPECT_LT(list.back(), 0.85);
    EXPECT_GT(list.back(), 0.5 / std::sqrt(3)) << "far too careful";
}

/// Heuristic: near the axis the estimate may be too large.
TEST(Mandelbulb, estimates_no_more_than_the_distance_almost_everywhere) {
    for (const double power : {2.0, 3.0, 8.0, 16.0}) {
        const auto list = factors(
            mandelbulb(power, 8), [&](dvec3 p) { return is_in_mandelbulb(p, power, 8); }, 46);
        EXPECT_GT(list.front(), 0) << power;
        EXPECT_LT(part_of(list, 0.98), 0.85) << power;
        EXPECT_LT(part_of(list, 0.99), 1) << power;
        EXPECT_LT(part_of(list, 0.998), 3) << power;
        EXPECT_LT(list.back(), 8) << power;
        EXPECT_GT(part_of(list, 0.99), 0.4) << power << ": far too careful";
    }
}

/// In its own words: reflect each coordinate into the box, invert near the middle, enlarge, add.
bool is_in_mandelbox(dvec3 point, double scale, int iterations) {
    dvec3 p = point;
    for (int i = 0; i <= iterations; ++i) {
        if (glm::length(p) > 64) return false;
        for (int k = 0; k < 3; ++k) {
            if (p[k] > 1) {
                p[k] = 2 - p[k];
            } else if (p[k] < -1) {
                p[k] = -2 - p[k];
            }
        }
        const double square = glm::dot(p, p);
        const double factor = square < 0.25 ? 4 : square < 1 ? 1 / square : 1;
        p = scale * factor * p + point;
    }
    return true;
}

Fractal mandelbox(double scale, int iterations) {
    return Fractal(fmt::format("mandelbox({}, {})", scale, iterations));
}

TEST(Mandelbox, has_the_members_of_the_plain_iteration) {
    for (const double scale : {2.0, 3.0, -1.5}) {
        expect_members(mandelbox(scale, 4), 47, scale < 0 ? 2.5 : 5,
                       [&](dvec3 p) { return is_in_mandelbox(p, scale, 4); });
    }
}

/// Heuristic: the radius of what is drawn at each depth is that of a ball about the orbit.
TEST(Mandelbox, estimates_no_more_than_the_distance_almost_everywhere) {
    for (const double scale : {2.0, 3.0, -1.5}) {
        const auto list = factors(
            mandelbox(scale, 12), [&](dvec3 p) { return is_in_mandelbox(p, scale, 12); }, 48,
            scale < 0 ? 2.5 : 5, 1000);
        EXPECT_GT(list.front(), 0) << scale;
        EXPECT_LT(part_of(list, 0.99), scale < 0 ? 1 : 0.85) << scale;
        EXPECT_LT(list.back(), scale < 0 ? 1.1 : 0.95) << scale;
        EXPECT_GT(list.back(), 0.5) << scale << ": far too careful";
    }
}

/// By the definition: in a tetrahedron, and in one of four of half the size in its corners.
bool is_in_sierpinski(dvec3 p, int levels) {
    const double x = p.x, y = p.y, z = p.z;
    if (std::max({x + y - z, x - y + z, y + z - x, -x - y - z}) > 1) return false;
    if (levels == 0) return true;
    for (const dvec3 corner : {dvec3(1, 1, 1), {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}) {
        if (is_in_sierpinski(2.0 * p - corner, levels - 1)) return true;
    }
    return false;
}

TEST(Sierpinski, agrees_with_the_recursive_definition) {
    for (const int levels : {0, 1, 2, 4}) {
        expect_members(Fractal(fmt::format("sierpinski({})", levels)), 49, 1.05,
                       [&](dvec3 p) { return is_in_sierpinski(p, levels); });
    }
}

TEST(Sierpinski, is_one_lipschitz) {
    for (const int levels : {0, 1, 5}) {
        expect_lipschitz(Fractal(fmt::format("sierpinski({})", levels)), 50, 2, 1500);
    }
}

TEST(Sierpinski, estimates_no_more_than_the_distance) {
    const auto list = factors(
        Fractal("sierpinski(3)"), [](dvec3 p) { return is_in_sierpinski(p, 3); }, 51, 1.05);
    EXPECT_GT(list.front(), 0);
    EXPECT_LE(list.back(), 1);
}

/// The factors of a field whose own sign says what is inside.
std::vector<double> own_factors(const char* text, double size) {
    const Fractal fractal(text);
    return factors(
        fractal, [&](dvec3 p) { return fractal.value(p) == -INFINITY; }, 52, size, 100);
}

/// Mirrors and turns keep distances, and what is left lies in a ball.
TEST(Kaleidoscope, estimates_no_more_than_the_distance) {
    const auto list = own_factors("kaleidoscope(25, 12, iterations = 8)", 1.2);
    EXPECT_LE(list.back(), 1);
    EXPECT_GT(list.back(), 0.3) << "far too careful";
}

/// Heuristic: derived from linear steps, and by dual numbers.
TEST(Hybrids, estimate_hardly_more_than_the_distance) {
    for (const char* text : {"folded_sponge(iterations = 6)", "alternating_bulb(iterations = 5)"}) {
        const auto list = own_factors(text, 1.3);
        EXPECT_GT(list.front(), 0) << text;
        EXPECT_LT(list.back(), 1.05) << text;
        EXPECT_GT(list.back(), 0.2) << text << ": far too careful";
    }
}

}  // namespace
}  // namespace formula
