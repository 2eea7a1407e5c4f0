// SPDX-License-Identifier: MIT
#include "analysis/leaf_bricks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "analysis/cell_derivatives.h"
#include "analysis/evaluator.h"
#include "analysis/in_parallel.h"

namespace analysis {
namespace {

using numeric::Interval;
using Jet = numeric::SecondOrder<Interval>;

/// A jet of intervals costs so many times an interval.
constexpr std::size_t jet_weight = 16;
/// A brick is stiff where most certified steps are shorter than this part of it.
constexpr double shortest_step = 1.0 / 32;

/// Eight bricks in one; undecided unless all are the same.
Bricks coarsened(const Bricks& fine) {
    Bricks coarse{{fine.grid.box, fine.grid.side / 2}, {}};
    coarse.bricks.resize(coarse.grid.count());
    for (std::size_t i = 0; i < coarse.bricks.size(); ++i) {
        const glm::ivec3 corner = 2 * coarse.grid.at(i);
        coarse.bricks[i] = fine.at(corner);
        for (int child = 1; child < 8; ++child) {
            const glm::ivec3 offset(child & 1, child >> 1 & 1, child >> 2);
            if (fine.at(corner + offset) != coarse.bricks[i]) coarse.bricks[i] = Brick::surface;
        }
    }
    return coarse;
}

/// A formula with its parameters loaded, for one thread.
struct Evaluators {
    RootEvaluator<Jet> jets;
    RootEvaluator<Interval> intervals;

    Evaluators(const eval::Tape& f, std::span<const double> parameters)
        : jets(f, parameters), intervals(f, parameters) {}

    Jet over(const Cell& cell) {
        const auto sides = cell.sides();
        return jets(std::array{Jet::variable(sides[0], 0), Jet::variable(sides[1], 1),
                               Jet::variable(sides[2], 2)})[0];
    }
    Interval at(glm::dvec3 point) {
        return intervals(std::array<Interval, 3>{point.x, point.y, point.z})[0];
    }
};

/// Encloses f over the cell by its value in the middle and its gradient; f is continuous there.
Interval mean_value(const Cell& cell, const Jet& f, const Interval& middle) {
    const auto sides = cell.sides();
    Interval sum = middle;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        sum = sum + f.gradient[i] * (sides[i] - Interval(cell.middle()[axis]));
    }
    return sum;
}

/// The median of |f| in the middles of the cell's eight parts.
double median_magnitude(Evaluators& evaluators, const Cell& cell) {
    const auto sides = cell.sides();
    std::array<double, 8> magnitudes;
    for (int part = 0; part < 8; ++part) {
        glm::dvec3 point;
        for (int axis = 0; axis < 3; ++axis) {
            const auto& side = sides[static_cast<std::size_t>(axis)];
            const double share = (part >> axis & 1) != 0 ? 0.75 : 0.25;
            point[axis] = side.lo + share * (side.hi - side.lo);
        }
        magnitudes[static_cast<std::size_t>(part)] = numeric::magnitude(evaluators.at(point));
    }
    const auto median = magnitudes.begin() + magnitudes.size() / 2;
    std::ranges::nth_element(magnitudes, median);
    return *median;
}

/// `typical` is a usual |f|.
BrickBounds bounds_of(const Jet& f, double typical, double brick_size, bool walls_known) {
    BrickBounds bounds;
    bounds.breaks = walls_known ? f.value.partial : may_break_on(f.value);
    bounds.lipschitz = gradient_bound_on(f);
    bounds.second_derivative = second_derivative_bound_on(f, 0);
    const double step =
        std::max(typical / bounds.lipschitz, std::sqrt(2 * typical / bounds.second_derivative));
    bounds.stiff = !(step > shortest_step * brick_size);  // also where it is NaN
    return bounds;
}

/// What is known of one cell.
struct Look {
    BrickBounds bounds;
    Brick brick = Brick::surface;
};

/// Looks at a formula over cells of one size.
struct Looker {
    Evaluators evaluators;
    double size;
    bool sheet;
    bool walls_known;

    Look over(const Cell& cell) {
        const Jet jet = evaluators.over(cell);
        Look look{bounds_of(jet, median_magnitude(evaluators, cell), size, walls_known)};
        if (may_break_on(jet.value) || !std::isfinite(look.bounds.lipschitz)) return look;
        const Interval value = mean_value(cell, jet, evaluators.at(cell.middle()));
        if (value.is_empty() || value.partial || value.contains(0)) return look;
        look.brick = sheet || value.lo > 0 ? Brick::outside : Brick::inside;
        return look;
    }
};

}  // namespace

LeafBricks leaf_bricks(const field::Field& field, field::FieldId id, const eval::Tape& f,
                       std::span<const double> parameters, const Region& region,
                       const BrickEffort& effort, bool walls_known) {
    LeafBricks result{bricks(field, id, parameters, region, effort), {}};
    Bricks& found = result.bricks;
    const auto jet_operations = [&] {
        return (found.bricks.size() - found.decided()) * (f.instructions.size() + 1) * jet_weight;
    };
    while (found.grid.side > 1 && jet_operations() > effort.jet_operations) {
        found = coarsened(found);
    }
    result.bounds.resize(found.bricks.size());
    const Region where = padded(region);
    const bool sheet = kind_of(field, id) == field::Kind::sheet;
    // Cells of one brick, or of many.
    const auto look_at_cells = [&](const BrickGrid& cells) {
        const double size = glm::length(cells.size()) / std::sqrt(3.0);
        const BrickGrid within{{}, found.grid.side / cells.side};
        in_parallel(
            cells.count(), effort.threads,
            [&] {
                return Looker{{f, parameters}, size, sheet, walls_known};
            },
            [&](Looker& looker, std::size_t place) {
                const auto brick = [&](std::size_t i) {
                    return found.grid.place(cells.at(place) * within.side + within.at(i));
                };
                std::vector<std::size_t> open;
                for (std::size_t i = 0; i < within.count(); ++i) {
                    if (found.bricks[brick(i)] == Brick::surface) open.push_back(brick(i));
                }
                if (open.empty() || (cells.side > 1 && is_over(effort.budget))) return;
                const auto cell = clip(where, cells.widened(cells.at(place)));
                if (!cell) return;
                const Look look = looker.over(*cell);
                for (const std::size_t i : open) {
                    result.bounds[i] = look.bounds;
                    found.bricks[i] = look.brick;
                }
            });
    };
    constexpr int finer = 4;
    if (effort.budget) {
        for (int side = 1; side < found.grid.side; side *= finer) {
            look_at_cells({found.grid.box, side});
        }
    }
    look_at_cells(found.grid);
    return result;
}

}  // namespace analysis
