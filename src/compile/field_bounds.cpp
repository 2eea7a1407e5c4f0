// SPDX-License-Identifier: MIT
#include "compile/field_bounds.h"

#include <algorithm>

#include "analysis/heuristic_stiffness.h"
#include "analysis/image_region.h"
#include "analysis/jacobian_norm.h"
#include "field/overloaded.h"
#include "field/parts.h"
#include "numeric/rounding.h"

namespace compile {
namespace {

using analysis::Region;
using field::FieldId;

/// Everywhere: bounds over it are those that hold without looking at a region.
const Region all_of_space{glm::dvec3(0), glm::dvec3(numeric::infinity), false};

void add_tapes(const field::Field& field, FieldId id, BoundTapes& tapes) {
    const auto tape = [&](graph::NodeId node) {
        return eval::make_tape(field.graph, std::array{node});
    };
    const auto image_tape = [&](const field::Image& image) {
        std::vector<graph::NodeId> roots(image.point.begin(), image.point.end());
        if (image.turn) roots.push_back(*image.turn);
        return eval::make_tape(field.graph, roots);
    };
    std::visit(
        field::Overloaded{
            [&](const field::Formula& leaf) {
                const bool sheet = leaf.kind == field::Kind::sheet;
                if (leaf.metric == field::Metric::distance && !sheet) return;
                tapes.formulas.try_emplace(id, tape(leaf.value));
                for (const field::Distortion& it : leaf.distortions) {
                    DistortionTapes distortion{image_tape(it.image), {}};
                    if (it.displacement) {
                        distortion.displacement = tape(*it.displacement);
                    }
                    tapes.distortions[id].push_back(std::move(distortion));
                }
            },
            [&](const field::Iteration& leaf) {
                if (!leaf.image) return;
                tapes.distortions[id].push_back({image_tape(*leaf.image), {}});
            },
            [&](const field::Blend& node) {
                if (!node.displacement) return;
                tapes.displacements.try_emplace(id, tape(*node.displacement));
            },
            [&](const field::Cells& node) {
                tapes.cells[id] = {tape(node.point[0]), tape(node.point[1]), tape(node.point[2])};
            },
            [](const auto&) {},
        },
        field[id]);
    for (const FieldId child : children(field[id])) add_tapes(field, child, tapes);
}

}  // namespace

BoundTapes bound_tapes(const field::Field& field) {
    BoundTapes tapes;
    add_tapes(field, field.root, tapes);
    return tapes;
}

const std::optional<Region>& FieldBounds::region(const Path& cells) {
    if (cells.empty()) return region_;
    const auto found = regions_.find(cells);
    if (found != regions_.end()) return found->second;
    const std::optional<Region> outside = region({cells.begin(), cells.end() - 1});
    return regions_[cells] = analysis::image_region(tapes_.cells.at(cells.back()),
                                                    outside.value_or(all_of_space), parameters_);
}

double FieldBounds::of_displacement(const eval::Tape& tapes, const Path& cells) {
    const Region where = region(cells).value_or(all_of_space);
    if (analysis::may_break(tapes, where, parameters_, effort_)) return numeric::infinity;
    return analysis::gradient_bound(tapes, where, parameters_, effort_);
}

double FieldBounds::of_distortions(FieldId leaf, const Path& cells) {
    const auto found = tapes_.distortions.find(leaf);
    if (found == tapes_.distortions.end()) return numeric::infinity;
    const Region where = region(cells).value_or(all_of_space);
    double largest = 0;
    for (const DistortionTapes& it : found->second) {
        double constant = analysis::jacobian_norm_bound(it.image, where, parameters_, effort_);
        if (it.displacement) {
            constant = numeric::add_up(constant, of_displacement(*it.displacement, cells));
        }
        largest = std::max(largest, constant);
    }
    return largest;
}

analysis::LeafBounds FieldBounds::leaf_bounds(FieldId leaf, const Path& cells) {
    const std::optional<Region>& where = region(cells);
    // Rays without an end leave every region that could be bounded: the first order takes over.
    if (!where) return {};
    const eval::Tape& tapes = tapes_.formulas.at(leaf);
    analysis::LeafBounds bounds = analysis::leaf_bounds(tapes, *where, parameters_, effort_);
    const double by_rules = of_distortions(leaf, cells);
    if (by_rules < numeric::infinity && (bounds.partial || by_rules < bounds.lipschitz)) {
        // What is made of distances by continuous maps is continuous.
        if (bounds.partial) bounds.second_derivative = numeric::infinity;
        bounds.partial = false;
        bounds.lipschitz = std::min(bounds.lipschitz, by_rules);
        bounds.stiff = analysis::heuristic_steps(tapes, *where, parameters_, bounds.lipschitz,
                                                 bounds.second_derivative) > analysis::stiff_steps;
    }
    return bounds;
}

const analysis::LeafBounds& FieldBounds::of_leaf(FieldId leaf, const Path& cells) {
    const Place place{leaf, cells};
    const auto found = leaves_.find(place);
    if (found != leaves_.end()) return found->second;
    return leaves_[place] = leaf_bounds(leaf, cells);
}

double FieldBounds::lipschitz(FieldId node, const Path& cells) {
    const auto largest = [&](const std::vector<FieldId>& nodes, const Path& path) {
        double result = 0;
        for (const FieldId it : nodes) result = std::max(result, lipschitz(it, path));
        return result;
    };
    return std::visit(field::Overloaded{
                          [&](const field::Formula&) {
                              if (!tapes_.formulas.contains(node)) return 1.0;
                              const analysis::LeafBounds& bounds = of_leaf(node, cells);
                              return bounds.partial ? numeric::infinity : bounds.lipschitz;
                          },
                          [&](const field::Iteration& leaf) {
                              return leaf.image ? of_distortions(node, cells) : 1.0;
                          },
                          [&](const field::Blend& blend) {
                              const double operands = largest(blend.operands, cells);
                              if (!blend.displacement) return operands;
                              return numeric::add_up(
                                  operands, of_displacement(tapes_.displacements.at(node), cells));
                          },
                          [&](const field::Cells& it) {
                              Path inside = cells;
                              inside.push_back(node);
                              return lipschitz(it.a, inside);
                          },
                          [&](const auto&) { return largest(children(field_[node]), cells); },
                      },
                      field_[node]);
}

}  // namespace compile
