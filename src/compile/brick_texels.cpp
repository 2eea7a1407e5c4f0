// SPDX-License-Identifier: MIT
#include "compile/brick_texels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include <glm/vector_relational.hpp>

#include "analysis/leaf_bricks.h"
#include "analysis/polynomial_degree.h"
#include "analysis/uniform_curvature.h"
#include "field/overloaded.h"
#include "field/parts.h"
#include "passes/jump_walls.h"

namespace compile {
namespace {

using analysis::Brick;
using analysis::BrickBounds;
using analysis::LeafBricks;
using field::FieldId;

/// More formulas are known by one bound of the region each.
constexpr std::size_t most_leaves = 4;
/// Polynomials to this degree are followed by their coefficients along the ray.
constexpr int largest_degree = 12;
constexpr float no_bound = 1e30F;

void add_leaves(const field::Field& field, FieldId id, std::vector<FieldId>& leaves) {
    const auto below = [&] {
        for (const FieldId child : children(field[id])) add_leaves(field, child, leaves);
    };
    std::visit(field::Overloaded{
                   [&](const field::Formula& leaf) {
                       if (leaf.metric == field::Metric::distance) return;
                       if (!leaf.distortions.empty()) return;
                       const auto degree = analysis::polynomial_degree(field.graph, leaf.value);
                       if (degree && *degree <= largest_degree) return;
                       if (analysis::has_uniform_curvature(field.graph, leaf.value)) return;
                       if (std::ranges::find(leaves, id) == leaves.end()) leaves.push_back(id);
                   },
                   [](const field::Iteration&) {},
                   [](const field::Blend&) {},
                   [](const field::Cells&) {},
                   [&](const auto&) { below(); },
               },
               field[id]);
}

float rounded_up(double value) { return std::nextafter(static_cast<float>(value), INFINITY); }
float rounded_down(double value) { return std::nextafter(static_cast<float>(value), 0.0F); }

/// How many bricks away, in any direction, the next is that is not `empty`; 0 for itself. Two
/// passes over all neighbours before and behind (Rosenfeld & Pfaltz 1966), exact for this distance.
template <class Empty>
std::vector<int> bricks_to_others(const analysis::Bricks& bricks, Empty empty) {
    const int side = bricks.grid.side;
    std::vector<int> steps(bricks.bricks.size(), side);
    const auto look_back = [&](int first, int step) {
        const auto nearer = [&](glm::ivec3 at, glm::ivec3 by) {
            const glm::ivec3 other = at + by;
            if (glm::any(glm::lessThan(other, glm::ivec3(0))) ||
                glm::any(glm::greaterThanEqual(other, glm::ivec3(side)))) {
                return side;
            }
            return steps[bricks.grid.place(other)] + 1;
        };
        for (int i = 0; i < static_cast<int>(steps.size()); ++i) {
            const auto place = static_cast<std::size_t>(first + step * i);
            int& here = steps[place];
            if (!empty(bricks.bricks[place])) here = 0;
            if (here == 0) continue;
            const glm::ivec3 at = bricks.grid.at(place);
            for (int z = -1; z <= 0; ++z) {
                for (int y = -1; y <= (z < 0 ? 1 : 0); ++y) {
                    for (int x = -1; x <= (z < 0 || y < 0 ? 1 : -1); ++x) {
                        here = std::min(here, nearer(at, step * glm::ivec3(x, y, z)));
                    }
                }
            }
        }
    };
    look_back(0, 1);
    look_back(static_cast<int>(steps.size()) - 1, -1);
    return steps;
}

/// As shaders/brick/brick.glsl reads it.
std::array<float, 2> texel(const BrickBounds& bounds) {
    const bool certified = bounds.certified();
    const float inverse = !bounds.breaks && std::isfinite(bounds.lipschitz)
                              ? std::clamp(rounded_down(1 / bounds.lipschitz), 1e-30F, no_bound)
                              : 1e-30F;
    const float second = bounds.breaks || !(bounds.second_derivative < 1e30)
                             ? no_bound
                             : rounded_up(bounds.second_derivative);
    return {certified ? inverse : -inverse, second};
}

template <class Kind>
bool holds(const field::Field& field, FieldId id) {
    return std::holds_alternative<Kind>(field[id]) ||
           std::ranges::any_of(children(field[id]),
                               [&](FieldId child) { return holds<Kind>(field, child); });
}

/// One of the grids that a program reads.
struct KnownGrid {
    analysis::BrickGrid grid;
    std::vector<int> steps;           ///< bricks_to_others
    std::vector<BrickBounds> bounds;  ///< where that is 0
};

std::shared_ptr<const shader::BrickTexels> stacked(const std::vector<KnownGrid>& known) {
    auto result = std::make_shared<shader::BrickTexels>();
    result->grids = static_cast<int>(known.size());
    for (const KnownGrid& it : known) result->side = std::max(result->side, it.grid.side);
    const analysis::BrickGrid fine{{}, result->side};
    for (const KnownGrid& it : known) {
        const int ratio = result->side / it.grid.side;
        for (std::size_t i = 0; i < fine.count(); ++i) {
            const std::size_t place = it.grid.place(fine.at(i) / ratio);
            const int steps = it.steps[place];
            const std::array<float, 2> numbers =
                steps > 0 ? std::array{1.0F, -static_cast<float>(ratio * (steps - 1) + 1)}
                          : texel(it.bounds[place]);
            result->texels.insert(result->texels.end(), numbers.begin(), numbers.end());
        }
    }
    return result;
}

}  // namespace

std::vector<FieldId> brick_leaves(const field::Field& field) {
    std::vector<FieldId> leaves;
    add_leaves(field, field.root, leaves);
    if (leaves.size() > most_leaves) leaves.resize(most_leaves);
    return leaves;
}

bool has_scene_bricks(const field::Field& field) {
    return holds<field::Cells>(field, field.root) && !holds<field::Iteration>(field, field.root);
}

std::shared_ptr<const shader::BrickTexels> brick_texels(const field::Field& field,
                                                        const BoundTapes& tapes,
                                                        std::span<const FieldId> leaves, bool scene,
                                                        const analysis::Region& region,
                                                        std::span<const double> parameters,
                                                        const analysis::Budget* budget) {
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const analysis::BrickEffort effort{
        .side = leaves.empty() ? 32 : 16, .threads = threads, .budget = budget};
    const auto no_surface = [](Brick brick) { return brick != Brick::surface; };
    const auto nothing = [](Brick brick) { return brick == Brick::outside; };
    std::vector<KnownGrid> known;
    for (const FieldId id : leaves) {
        const graph::NodeId value = std::get<field::Formula>(field[id]).value;
        LeafBricks leaf =
            analysis::leaf_bricks(field, id, tapes.formulas.at(id), parameters, region, effort,
                                  passes::jumps_at_planes(field.graph, value));
        std::vector<int> steps = bricks_to_others(leaf.bricks, no_surface);
        known.push_back({leaf.bricks.grid, std::move(steps), std::move(leaf.bounds)});
    }
    if (scene) {
        const analysis::Bricks all =
            analysis::bricks(field, field.root, parameters, region, effort);
        std::vector<BrickBounds> anything(all.bricks.size());
        known.push_back({all.grid, bricks_to_others(all, nothing), std::move(anything)});
    }
    return stacked(known);
}

}  // namespace compile
