// SPDX-License-Identifier: MIT
#include "compile/precision.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "analysis/heuristic_displacement.h"
#include "compile/visible_region.h"
#include "field/parts.h"
#include "passes/recentre.h"
#include "shader/family.h"

namespace compile {
namespace {

using field::FieldId;
using shader::Precision;

/// A surface may be moved by this part of a pixel.
constexpr double allowed_part = 1.0 / 8;
constexpr double rows = 1080;
/// Half a unit in the last place of 1.
constexpr double unit_roundoff = 0x1p-24;
/// By how much more than the rounding of its point an iteration's surface moves: measured on zooms
/// into fractals (docs/numerics.md). Folds of space round a point once or twice.
constexpr double iteration_factor = 16;
constexpr double cells_factor = 4;
/// So many points are looked at in all leaves together, and in one at most.
constexpr std::size_t most_samples = 1024;
constexpr std::size_t most_samples_of_leaf = 48;
/// And fewer where that would be so many operators and more; that is longer than a slider can wait.
constexpr std::size_t most_operators = 100'000;
constexpr std::size_t least_samples_of_leaf = 8;

double largest(glm::dvec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// What is looked at, in the coordinates of a program.
struct Look {
    glm::dvec3 eye, target;
    double distance = 0;
    double radius = 0;  ///< of what is seen around the target

    /// The rounding of eye + t * direction.
    double position() const { return 2 * unit_roundoff * std::max(largest(eye), largest(target)); }
};

Look look_of(const scene::Document& document) {
    const scene::Camera camera = scene::camera_of(document, 16.0 / 9);
    Look look{camera.eye, camera.target};
    look.distance = glm::distance(camera.eye, camera.target);
    look.radius = look.distance * std::tan(camera.fov * std::numbers::pi / 360);
    return look;
}

/// How far single precision moves the surfaces of a field.
class Displacement {
public:
    /// `unknown` is that of a formula whose errors have no bound, such as at the edge of a domain.
    Displacement(const field::Field& field, const Look& look, std::span<const double> parameters,
                 double unknown)
        : field_(field), look_(look), parameters_(parameters), unknown_(unknown) {
        samples_ = std::clamp<std::size_t>(most_samples / leaves(field, field.root).size(), 1,
                                           most_samples_of_leaf);
        visit(field.root, false);
    }
    double most() const { return most_; }

private:
    void visit(FieldId id, bool in_cells) {
        const field::Node& node = field_[id];
        if (const auto* leaf = std::get_if<field::Formula>(&node)) {
            add(in_cells ? cells_factor * look_.position() : of_formula(*leaf));
        } else if (std::holds_alternative<field::Iteration>(node)) {
            add(iteration_factor * look_.position());
        }
        const bool cells = in_cells || std::holds_alternative<field::Cells>(node);
        for (const FieldId child : children(node)) visit(child, cells);
    }

    double of_formula(const field::Formula& leaf) const {
        const eval::Tape tape = eval::make_tape(field_.graph, std::array{leaf.value});
        const analysis::Region seen{look_.target, glm::dvec3(look_.radius), true};
        const std::size_t samples = std::clamp(most_operators / (tape.instructions.size() + 1),
                                               least_samples_of_leaf, most_samples_of_leaf);
        const auto found =
            analysis::heuristic_displacement(tape, seen, parameters_, look_.position(),
                                             static_cast<unsigned>(std::min(samples, samples_)));
        if (!found) return look_.position();
        return std::isfinite(*found) ? *found : unknown_;
    }

    void add(double displacement) { most_ = std::max(most_, displacement); }

    const field::Field& field_;
    const Look& look_;
    std::span<const double> parameters_;
    double unknown_;
    std::size_t samples_ = 1;
    double most_ = 0;
};

bool has_cells(const field::Field& field) {
    return std::ranges::any_of(field.nodes, [](const field::Node& node) {
        return std::holds_alternative<field::Cells>(node);
    });
}

/// Families hold distances in world coordinates; as text their members would be too much.
bool has_families(field::Field field) {
    const bool has_minima = std::ranges::any_of(field.nodes, [](const field::Node& node) {
        const auto* leaf = std::get_if<field::Formula>(&node);
        return leaf && !leaf->minima.empty();
    });
    return has_minima || !shader::gather_families(field).empty();
}

/// What coordinates about the target would leave; +infinity where there are none.
double recentred_displacement(const Formula& formula, const Look& look, glm::dvec3 origin,
                              std::vector<double> parameters) {
    if (has_cells(formula.field) || has_families(formula.field)) return numeric::infinity;
    field::Field field = formula.field;
    passes::recentre(field);
    parameters.insert(parameters.end(), {origin.x, origin.y, origin.z});
    Look about = look;
    about.eye -= origin;
    about.target -= origin;
    // Iterations stay as they are: their first turn rounds the point to world coordinates.
    const Displacement displaced(field, about, parameters, numeric::infinity);
    const bool iterates = std::ranges::any_of(field.nodes, [](const field::Node& node) {
        return std::holds_alternative<field::Iteration>(node);
    });
    return iterates ? std::max(displaced.most(), iteration_factor * look.position())
                    : displaced.most();
}

std::string moved_by(double displacement, double pixel) {
    return fmt::format("single precision moves the surface by {:.2g} of a pixel",
                       displacement / pixel);
}

}  // namespace

glm::dvec3 recentred_origin(const scene::Document& document) {
    return document.camera ? document.camera->target : framed_region(document.bounds).centre;
}

bool look_alike(const scene::Document& a, const scene::Document& b) {
    const Look first = look_of(a), second = look_of(b);
    const double ratio = first.distance / second.distance;
    return ratio < 2 && ratio > 0.5 &&
           glm::distance(first.target, second.target) < 0.5 * first.distance;
}

PrecisionChoice choose_precision(const Formula& formula, const scene::Document& document) {
    const std::string& wanted = document.settings.precision;
    if (wanted == "single") return {Precision::single, "as chosen"};
    if (wanted == "double") return {Precision::doubled, "as chosen"};
    const Look look = look_of(document);
    const double pixel = 2 * look.radius / rows;
    const std::vector<double> parameters = parameter_values(formula.field, document);
    const double single = Displacement(formula.field, look, parameters, look.position()).most();
    if (!(single > allowed_part * pixel)) return {Precision::single, moved_by(single, pixel)};
    const double recentred =
        recentred_displacement(formula, look, recentred_origin(document), parameters);
    const bool enough = recentred <= allowed_part * pixel;
    return {enough ? Precision::recentred : Precision::doubled, moved_by(single, pixel)};
}

}  // namespace compile
