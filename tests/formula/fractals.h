// SPDX-License-Identifier: MIT
// Escape-time fields by their texts, their values, and distances from them by search.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "formula/understood.h"

namespace formula {

using Random = std::mt19937_64;

/// Evenly in the cube from -size to size.
inline glm::dvec3 random_point(Random& random, double size) {
    std::uniform_real_distribution<double> number(-size, size);
    const double x = number(random), y = number(random), z = number(random);
    return {x, y, z};
}

inline std::string describe(glm::dvec3 p) {
    return testing::PrintToString(std::array{p.x, p.y, p.z});
}

/// The field of a text, with all parameters at their initial values.
class Fractal {
public:
    explicit Fractal(std::string_view text) {
        base::Result<Lowered> lowered = understand(text);
        if (!lowered) {
            ADD_FAILURE() << report_of(text);
            lowered = understand("sphere(1)");
        }
        field_ = std::move(lowered->field);
        parameters_.resize(field_.graph.parameter_count());
        for (const field::Parameter& it : field_.parameters) {
            for (std::size_t i = 0; i < it.ids.size(); ++i) {
                parameters_[graph::index(it.ids[i])] = it.initial[i];
            }
        }
    }
    double value(glm::dvec3 p) const { return eval::value(field_, field_.root, p, parameters_); }
    const field::Field& field() const { return field_; }

private:
    field::Field field_;
    std::vector<double> parameters_;
};

/// Fails where the value changes by more than the distance between two points, near and far.
inline void expect_lipschitz(const Fractal& fractal, unsigned seed, double size, int pairs) {
    Random random(seed);
    for (int i = 0; i < pairs; ++i) {
        const glm::dvec3 p = random_point(random, size);
        const double nearness = std::exp2(-static_cast<double>(random() % 16));
        const glm::dvec3 q = p + nearness * random_point(random, size);
        const double change = std::abs(fractal.value(p) - fractal.value(q));
        ASSERT_LE(change, glm::distance(p, q) * (1 + 1e-9) + 1e-12)
            << "seed " << seed << ": " << describe(p) << " and " << describe(q);
    }
}

using IsInside = std::function<bool(glm::dvec3)>;

/// Points of the set's surface, up to 1e-9: between a point inside and one outside.
inline std::vector<glm::dvec3> surface_points(const IsInside& is_inside, double size,
                                              std::size_t count, Random& random) {
    std::vector<glm::dvec3> list;
    while (list.size() < count) {
        glm::dvec3 in = random_point(random, size), out = random_point(random, size);
        if (!is_inside(in) || is_inside(out)) continue;
        while (glm::distance(in, out) > 1e-9) {
            const glm::dvec3 middle = 0.5 * (in + out);
            (is_inside(middle) ? in : out) = middle;
        }
        list.push_back(in);
    }
    return list;
}

/// Estimates over the distance from the nearest of many points of the set, which is no less than
/// the distance from the set; in increasing order. From far away and closer and closer to the
/// surface of a set in the cube from -size to size.
inline std::vector<double> factors(const Fractal& fractal, const IsInside& is_inside, unsigned seed,
                                   double size = 1.3, std::size_t points = 4000) {
    Random random(seed);
    const std::vector<glm::dvec3> surface = surface_points(is_inside, size, points, random);
    std::vector<double> list;
    while (list.size() < points / 2) {
        const double away = std::exp2(-static_cast<double>(random() % 16));
        const glm::dvec3 p =
            surface[random() % surface.size()] + away * random_point(random, size / 1.3);
        if (is_inside(p)) continue;
        double nearest = INFINITY;
        for (const glm::dvec3& q : surface) nearest = std::min(nearest, glm::distance(p, q));
        list.push_back(fractal.value(p) / nearest);
    }
    std::ranges::sort(list);
    return list;
}

/// The number below which this part of the list lies.
inline double part_of(const std::vector<double>& sorted, double part) {
    return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

}  // namespace formula
