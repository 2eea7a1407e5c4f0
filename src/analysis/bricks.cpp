// SPDX-License-Identifier: MIT
#include "analysis/bricks.h"

#include <algorithm>

#include "analysis/content.h"
#include "analysis/in_parallel.h"

namespace analysis {
namespace {

/// What one thread takes less time for than another takes to start.
constexpr std::size_t operations_worth_a_thread = 50'000;

Brick brick_of(const Content& content) {
    if (content.sheet) return Brick::surface;
    if (content.solid.lo > 0) return Brick::outside;
    return content.solid.hi < 0 ? Brick::inside : Brick::surface;
}

/// Every brick cut into eight; what was decided stays so.
Bricks refined(const Bricks& coarse) {
    Bricks fine{{coarse.grid.box, 2 * coarse.grid.side}, {}};
    fine.bricks.resize(fine.grid.count());
    for (std::size_t i = 0; i < fine.bricks.size(); ++i) {
        fine.bricks[i] = coarse.at(fine.grid.at(i) / 2);
    }
    return fine;
}

std::vector<std::size_t> undecided(const Bricks& bricks) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < bricks.bricks.size(); ++i) {
        if (bricks.bricks[i] == Brick::surface) places.push_back(i);
    }
    return places;
}

}  // namespace

std::size_t BrickGrid::count() const {
    const auto n = static_cast<std::size_t>(side);
    return n * n * n;
}

std::size_t BrickGrid::place(glm::ivec3 at) const {
    return static_cast<std::size_t>((at.z * side + at.y) * side + at.x);
}

glm::ivec3 BrickGrid::at(std::size_t place) const {
    const int i = static_cast<int>(place);
    return {i % side, i / side % side, i / (side * side)};
}

Cell BrickGrid::widened(glm::ivec3 at) const {
    const glm::dvec3 size = this->size();
    const glm::dvec3 low = box.low + size * glm::dvec3(at);
    return {low - margin * size, low + (1 + margin) * size};
}

std::size_t Bricks::decided() const {
    return bricks.size() - static_cast<std::size_t>(std::ranges::count(bricks, Brick::surface));
}

Region padded(Region region) {
    region.half *= 1 + 1e-5;
    return region;
}

Bricks bricks(const field::Field& field, field::FieldId id, std::span<const double> parameters,
              const Region& region, const BrickEffort& effort) {
    const Region where = padded(region);
    ContentFinder first(field, id, parameters);
    const std::size_t operations_a_brick = first.operations() + 1;
    Bricks found{{bounding_cell(where), 1}, {Brick::surface}};
    std::size_t spent = 0;
    while (true) {
        const std::vector<std::size_t> open = undecided(found);
        const std::size_t operations = open.size() * operations_a_brick;
        spent += operations;
        const int threads = operations > operations_worth_a_thread ? effort.threads : 1;
        in_parallel(
            open.size(), threads, [&] { return ContentFinder(field, id, parameters); },
            [&](ContentFinder& content, std::size_t i) {
                if (found.grid.side > 1 && is_over(effort.budget)) return;
                const std::size_t place = open[i];
                const auto cell = clip(where, found.grid.widened(found.grid.at(place)));
                found.bricks[place] = cell ? brick_of(content.over(*cell)) : Brick::outside;
            });
        const std::size_t left = 8 * operations_a_brick * (found.bricks.size() - found.decided());
        if (left == 0 || 2 * found.grid.side > effort.side || spent + left > effort.operations ||
            is_over(effort.budget)) {
            return found;
        }
        found = refined(found);
    }
}

}  // namespace analysis
