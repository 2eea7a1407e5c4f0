// SPDX-License-Identifier: MIT
#include "analysis/region.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace analysis {
namespace {

/// Part of the region's size that rounding in tests of membership may amount to.
constexpr double margin = 1e-12;

/// Van der Corput's sequence: the digits of the number mirrored at the point.
double radical_inverse(unsigned number, unsigned base) {
    double result = 0, digit = 1.0 / base;
    for (; number > 0; number /= base, digit /= base) result += digit * (number % base);
    return result;
}

}  // namespace

Cell bounding_cell(const Region& region) {
    const glm::dvec3 low = region.centre - region.half, high = region.centre + region.half;
    const auto down = [](const glm::dvec3& v) {
        return glm::dvec3(numeric::next_down(v.x), numeric::next_down(v.y),
                          numeric::next_down(v.z));
    };
    return {down(low), -down(-high)};
}

std::optional<Cell> clip(const Region& region, const Cell& cell) {
    if (!region.sphere) return cell;
    const double radius = region.half.x * (1 + margin) + margin * glm::length(region.centre);
    const glm::dvec3 nearest = glm::clamp(region.centre, cell.low, cell.high) - region.centre;
    if (glm::length(nearest) > radius) return std::nullopt;
    Cell result = cell;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 others = nearest;
        others[axis] = 0;
        // Half of the ball's extent along this axis at its thickest part in the cell.
        const double reach =
            std::sqrt(std::max(0.0, radius * radius - glm::dot(others, others))) + margin * radius;
        result.low[axis] = std::max(cell.low[axis], region.centre[axis] - reach);
        result.high[axis] = std::min(cell.high[axis], region.centre[axis] + reach);
        if (result.low[axis] > result.high[axis]) return std::nullopt;
    }
    return result;
}

bool contains(const Region& region, glm::dvec3 point) {
    const glm::dvec3 offset = glm::abs(point - region.centre);
    if (region.sphere) return glm::length(offset) <= region.half.x;
    return glm::all(glm::lessThanEqual(offset, region.half));
}

double diameter(const Region& region) {
    return 2 * (region.sphere ? region.half.x : glm::length(region.half));
}

int longest_axis(const Cell& cell) {
    const glm::dvec3 size = cell.high - cell.low;
    return size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
}

std::array<Cell, 2> halves(const Cell& cell, int axis) {
    const double cut = cell.middle()[axis];
    std::array<Cell, 2> result{cell, cell};
    result[0].high[axis] = cut;
    result[1].low[axis] = cut;
    return result;
}

glm::dvec3 spread_point(const Region& region, unsigned number) {
    const glm::dvec3 unit(radical_inverse(number + 1, 2), radical_inverse(number + 1, 3),
                          radical_inverse(number + 1, 5));
    if (!region.sphere) return region.centre + region.half * (2.0 * unit - 1.0);
    const double height = 2 * unit.y - 1, angle = 2 * std::numbers::pi * unit.x;
    const double circle = std::sqrt(1 - height * height);
    const glm::dvec3 direction(circle * std::cos(angle), circle * std::sin(angle), height);
    return region.centre + region.half.x * std::cbrt(unit.z) * direction;
}

}  // namespace analysis
