// SPDX-License-Identifier: MIT
#include "analysis/heuristic_displacement.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "analysis/evaluator.h"
#include "analysis/rounding_error.h"

namespace analysis {
namespace {

constexpr int newton_steps = 6;
/// A point whose first-order distance is below this part of the region's size is on the surface.
constexpr double near_part = 1e-3;

struct OnSurface {
    glm::dvec3 point;
    double slope;  ///< the gradient's length
};

/// From a point to the surface by Newton's method, without leaving the region.
std::optional<OnSurface> towards_surface(RootEvaluator<numeric::Dual<double>>& f,
                                         const Region& region, glm::dvec3 p) {
    const double size = diameter(region);
    for (int i = 0; i < newton_steps; ++i) {
        const numeric::Dual<double> value = f(with_slopes<double>(coordinates(p)))[0];
        const glm::dvec3 g(value.gradient[0], value.gradient[1], value.gradient[2]);
        const double slope = glm::length(g);
        const double way = value.value / slope;
        if (!std::isfinite(way)) return std::nullopt;
        if (std::abs(way) < near_part * size) return OnSurface{p, slope};
        if (std::abs(way) > 4 * size) return std::nullopt;
        p -= way / slope * g;
        if (!contains(region, p)) return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace

std::optional<double> heuristic_displacement(const eval::Tape& f, const Region& region,
                                             std::span<const double> parameters, double position,
                                             unsigned samples) {
    RootEvaluator<numeric::Dual<double>> slopes(f, parameters);
    RoundingErrors errors(f, parameters);
    std::vector<double> moves;
    for (unsigned i = 0; i < samples; ++i) {
        const auto found = towards_surface(slopes, region, spread_point(region, i));
        if (!found) continue;
        const double error = errors(Cell{found->point, found->point}, position)[0].error;
        moves.push_back(error / found->slope);
    }
    if (moves.empty()) return std::nullopt;
    const auto quartile = moves.begin() + static_cast<std::ptrdiff_t>(3 * moves.size() / 4);
    std::ranges::nth_element(moves, quartile);
    return *quartile;
}

}  // namespace analysis
