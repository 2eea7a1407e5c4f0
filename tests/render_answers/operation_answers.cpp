// SPDX-License-Identifier: MIT
#include "render_answers/operation_answers.h"

#include <cmath>
#include <memory>
#include <numbers>

#include <glm/geometric.hpp>

namespace render_answers {
namespace {

using P = Polynomial;

const scene::Camera aside = camera({2.2, 1.6, 3.1});
const scene::Camera wide = camera({0.6, 0.5, 2.4}, {0.2, 0.1, 0}, 140);
const scene::Camera along_z = camera({0, 0, 5}, {0, 0, 0}, 50, {0, 0, 1});

/// Where the length of a vector with some components left out is below r: a ball, or an endless
/// tube along an axis. Intersected by the quadratic formula, which is much faster than `below`.
Solid round(double r, glm::dvec3 centre, glm::dvec3 components = glm::dvec3(1)) {
    const auto part = std::make_shared<int>();
    return [=](const Ray& ray) -> std::vector<Span> {
        const glm::dvec3 from = components * (ray.origin - centre);
        const glm::dvec3 by = components * ray.direction;
        const double a = glm::dot(by, by), b = glm::dot(from, by);
        const double square = b * b - a * (glm::dot(from, from) - r * r);
        if (!(square > 0)) return {};
        const auto crossing = [&](double t) { return Crossing{t, from + t * by, part.get()}; };
        return {{crossing((-b - std::sqrt(square)) / a), crossing((-b + std::sqrt(square)) / a)}};
    };
}

/// A solid turned about the z axis, counter-clockwise where that points at the eye.
Solid turned(const Solid& solid, double degrees) {
    const double c = std::cos(degrees * std::numbers::pi / 180);
    const double s = std::sin(degrees * std::numbers::pi / 180);
    const auto back = [=](glm::dvec3 v) {
        return glm::dvec3(c * v.x + s * v.y, c * v.y - s * v.x, v.z);
    };
    const auto forth = [=](glm::dvec3 v) {
        return glm::dvec3(c * v.x - s * v.y, c * v.y + s * v.x, v.z);
    };
    return [=](const Ray& ray) {
        std::vector<Span> spans = solid({back(ray.origin), back(ray.direction)});
        for (Span& span : spans) {
            span.enter.normal = forth(span.enter.normal);
            span.leave.normal = forth(span.leave.normal);
        }
        return spans;
    };
}

/// A box with everything within r of it: three boxes, twelve tubes along its edges, eight balls.
Solid rounded_box(glm::dvec3 half, double r) {
    Solid all = cuboid(half + glm::dvec3(r, 0, 0)) | cuboid(half + glm::dvec3(0, r, 0)) |
                cuboid(half + glm::dvec3(0, 0, r));
    for (const double i : {-1.0, 1.0}) {
        for (const double k : {-1.0, 1.0}) {
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 across(1), middle(0);
                across[axis] = 0;
                middle[(axis + 1) % 3] = i * half[(axis + 1) % 3];
                middle[(axis + 2) % 3] = k * half[(axis + 2) % 3];
                const Solid tube = round(r, middle, across);
                glm::dvec3 length(4);
                length[axis] = half[axis];
                all = all | (tube & cuboid(length));
            }
            for (const double m : {-1.0, 1.0}) all = all | round(r, half * glm::dvec3(i, k, m));
        }
    }
    return all;
}

Solid repeated_balls(double radius, double cell) {
    Solid all = nothing();
    for (int i = -2; i <= 2; ++i) {
        for (int j = -2; j <= 2; ++j) {
            for (int k = -2; k <= 2; ++k) {
                if (i * i + j * j + k * k > 5) continue;  // outside of the bounds
                all = all | round(radius, cell * glm::dvec3(i, j, k));
            }
        }
    }
    return all;
}

Solid gear(int teeth) {
    Solid all = nothing();
    for (int i = 0; i < teeth; ++i) {
        all = all | turned(cuboid({0.2, 0.1, 0.3}, {1, 0, 0}), 360.0 * i / teeth);
    }
    return all;
}

}  // namespace

std::vector<Answer> operation_answers() {
    const scene::Bounds two = sphere_bounds(2);
    const glm::dvec3 half{0.5, 0.6, 0.7};
    const auto shear = [](const P& x, const P& y, const P& z) {
        return (x + 0.5 * y) * (x + 0.5 * y) + y * y + z * z - 1.0;
    };
    return {
        {"offset_box", {"offset(box(0.5, 0.6, 0.7), 0.2)", two, aside}, rounded_box(half, 0.2)},
        {"offset_box_apart",
         {"offset(box(0.5, 0.6, 0.7) | colour(sphere(0.1), x), 0.2)", two, aside},
         rounded_box(half, 0.2)},
        {"shell_of_a_sphere",
         {"shell(sphere(0.8), 0.2) & z <= 0", two, aside},
         ball(0.9) & !ball(0.7) & half_space(0, 0, 1, 0)},
        {"repeated_spheres",
         {"repeat(sphere(0.3), (1, 1, 1))", two, aside},
         repeated_balls(0.3, 1)},
        {"repeated_spheres_wide",
         {"repeat(sphere(0.3), (1, 1, 1))", two, wide},
         repeated_balls(0.3, 1)},
        {"repeated_sphere_formulas",
         {"repeat(x^2 + y^2 + z^2 <= 0.09, (1, 1, 1))", two, aside},
         repeated_balls(0.3, 1)},
        {"repeated_sphere_sheets",
         {"repeat(x^2 + y^2 + z^2 = 0.09, (1, 1, 1))", two, aside},
         boundary(repeated_balls(0.3, 1))},
        {"offset_of_repeated_spheres",
         {"offset(repeat(sphere(0.2), (1, 1, 1)), 0.1)", two, aside},
         repeated_balls(0.3, 1)},
        {"scaled_repeated_spheres",
         {"scale(repeat(sphere(0.5), (2, 2, 2)), 0.5)", two, aside},
         repeated_balls(0.25, 1)},
        {"three_spheres",
         {"repeat(sphere(0.3), (0.8, 0.8, 0.8), count = (3, 1, 1))", two, aside},
         ball(0.3) | ball(0.3, {0.8, 0, 0}) | ball(0.3, {-0.8, 0, 0})},
        {"gear",
         {"repeat_polar(translate(box(0.2, 0.1, 0.3), (1, 0, 0)), 7)", two, aside},
         gear(7)},
        {"gear_along_z",
         {"repeat_polar(translate(box(0.2, 0.1, 0.3), (1, 0, 0)), 7)", two, along_z},
         gear(7)},
        {"mirrored",
         {"mirror(translate(sphere(0.5), (0.4, 0.2, 0)), (1, 0, 0))", two, aside},
         ball(0.5, {0.4, 0.2, 0}) | ball(0.5, {-0.4, 0.2, 0})},
        {"sheared",
         {"f(p) = (p.x + p.y/2, p.y, p.z)\nmap(sphere(1), f)", two, aside},
         below(shear)},
        {"scaled_by_coordinates",
         {"scale(sphere(1), (1.5, 0.5, 1))", two, aside},
         below([](const P& x, const P& y, const P& z) {
             return (1 / 2.25) * x * x + 4.0 * y * y + z * z - 1.0;
         })},
        {"displaced_plane",
         {"displace(plane(), (x^2 - y^2)/4) & sphere(1.5)", two, aside},
         below([](const P& x, const P& y, const P& z) { return z + 0.25 * (x * x - y * y); }) &
             ball(1.5)},
        {"chosen", {"if(t > 1, box(), sphere(1))", two, aside}, ball(1)},
    };
}

}  // namespace render_answers
