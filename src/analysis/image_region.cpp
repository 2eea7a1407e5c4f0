// SPDX-License-Identifier: MIT
#include "analysis/image_region.h"

#include <cmath>

#include "analysis/evaluator.h"

namespace analysis {

namespace {

double finite_or(double value, double other) { return std::isfinite(value) ? value : other; }

/// The region without its extent along coordinates that the expression does not need: then it is
/// not halved along these.
Region needed_part(const Region& region, const eval::Tape& tape) {
    if (tape.variables.size() >= 3) return region;
    Region part{region.centre, glm::dvec3(0), false};
    for (const graph::VariableId id : tape.variables) {
        const int axis = static_cast<int>(graph::index(id));
        part.half[axis] = region.half[axis];
    }
    return part;
}

/// The ends of one component over the region; infinite if none were found.
numeric::Interval range(const eval::Tape& tape, const Region& whole,
                        std::span<const double> parameters, const Effort& effort) {
    const Region region = needed_part(whole, tape);
    RootEvaluator<numeric::Interval> over(tape, parameters);
    RootEvaluator<double> at(tape, parameters);
    const auto here = [&](const Cell& cell) { return at(coordinates(cell.middle()))[0]; };
    const double size = supremum_bound(region, effort, [&](const Cell& cell) {
        return CellBounds{magnitude(over(cell.sides())[0]), finite_or(std::abs(here(cell)), 0)};
    });
    if (!std::isfinite(size)) return numeric::Interval::whole();
    // The suprema of the component and of its negative, counted from a floor below both, since
    // suprema are those of numbers above 0.
    const auto end = [&](double sign) {
        const double above = supremum_bound(region, effort, [&](const Cell& cell) {
            const numeric::Interval value = over(cell.sides())[0];
            const double upper = value.is_empty() ? -size : (sign < 0 ? -value.lo : value.hi);
            return CellBounds{size + upper, size + finite_or(sign * here(cell), -size)};
        });
        return numeric::add_up(above, -size) + 1e-12 * size;
    };
    return {-end(-1), end(1)};
}

}  // namespace

std::optional<Region> image_region(const std::array<eval::Tape, 3>& map, const Region& region,
                                   std::span<const double> parameters, const Effort& effort) {
    Region image{.centre = glm::dvec3(0), .half = glm::dvec3(0), .sphere = false};
    for (std::size_t i = 0; i < 3; ++i) {
        const numeric::Interval side = range(map[i], region, parameters, effort);
        if (!std::isfinite(side.lo) || !std::isfinite(side.hi)) return std::nullopt;
        const int axis = static_cast<int>(i);
        image.centre[axis] = 0.5 * (side.lo + side.hi);
        image.half[axis] = 0.5 * (side.hi - side.lo) * (1 + 1e-12);
    }
    return image;
}

}  // namespace analysis
