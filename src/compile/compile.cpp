// SPDX-License-Identifier: MIT
#include "compile/compile.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <span>

#include <glm/geometric.hpp>

#include "compile/brick_texels.h"
#include "compile/family_numbers.h"
#include "compile/precision.h"
#include "compile/visible_region.h"
#include "eval/tape.h"
#include "formula/lower.h"
#include "passes/pipeline.h"

namespace compile {
namespace {

using shader::FieldValue;

/// Nothing without bounds: rays without an end leave every region.
std::optional<analysis::Region> region_of(const scene::Bounds& bounds) {
    if (bounds.shape == scene::Bounds::Shape::none) return std::nullopt;
    return visible_region(bounds);
}

/// The number in single precision, on the safe side of the rounding.
float rounded_down(double value) { return std::nextafter(static_cast<float>(value), 0.0F); }
float rounded_up(double value) { return std::nextafter(static_cast<float>(value), INFINITY); }

float inverse_lipschitz(double lipschitz) {
    if (!std::isfinite(lipschitz)) return 0;
    return lipschitz > 0 ? rounded_down(1 / lipschitz) : 1e30F;
}

/// Where the members of a family are looked at; rays without an end mostly look there as well.
analysis::Region region_of(const shader::FamilyTree& tree, FieldBounds& bounds,
                           const scene::Bounds& visible) {
    const std::optional<analysis::Region> region = bounds.region(tree.cells);
    const bool bounded = region && std::isfinite(glm::length(region->half + region->centre));
    return bounded ? *region : visible_region(visible);
}

double number(const FieldValue& value, FieldBounds& bounds, std::span<const FamilyHeads> families,
              double expression) {
    switch (value.what) {
        case FieldValue::What::expression:
            return expression;
        case FieldValue::What::inverse_lipschitz:
            return inverse_lipschitz(bounds.lipschitz(value.node, value.cells));
        case FieldValue::What::second_derivative: {
            const analysis::LeafBounds leaf = bounds.of_leaf(value.node, value.cells);
            if (leaf.partial || !(leaf.second_derivative < 1e30)) return -1;
            return rounded_up(leaf.second_derivative);
        }
        case FieldValue::What::first_order: {
            const analysis::LeafBounds leaf = bounds.of_leaf(value.node, value.cells);
            return leaf.stiff || leaf.partial ? 1 : 0;
        }
        case FieldValue::What::family:
            return families[value.family][value.component];
    }
    return 0;
}

}  // namespace

base::Result<Formula> compile_formula(std::string_view text) {
    auto lowered = formula::understand(text);
    if (!lowered) return lowered.problems();
    Formula formula{std::move(lowered->field),
                    std::move(lowered->warnings),
                    lowered->result,
                    std::move(lowered->comparisons),
                    {},
                    {}};
    passes::run(formula.field);
    formula.tapes = bound_tapes(formula.field);
    formula.bricks = brick_leaves(formula.field);
    return formula;
}

shader::Features features(const Formula& formula, const scene::Document& document,
                          const shader::Outputs& outputs) {
    const scene::Settings& settings = document.settings;
    shader::Features features;
    features.tracer = settings.tracer;
    features.bounds_sphere = document.bounds.shape == scene::Bounds::Shape::sphere;
    features.bounds_box = document.bounds.shape == scene::Bounds::Shape::box;
    features.shadows = settings.shadows;
    features.grid = settings.grid;
    features.few_lights = document.lights.size() <= 2 && document.materials.size() <= 1;
    features.show_steps = settings.show_steps;
    features.show_certificate = settings.show_certificate;
    features.bricks = formula.bricks;
    features.skip_empty_bricks = has_scene_bricks(formula.field);
    features.outputs = outputs;
    return features;
}

shader::ProgramSource program_source(const Formula& formula, const scene::Document& document,
                                     shader::Outputs outputs) {
    shader::Features wanted = features(formula, document, outputs);
    wanted.precision = choose_precision(formula, document).precision;
    return shader::program_source(formula.field, wanted);
}

shader::FieldNumbers field_numbers(const Formula& formula, const shader::ProgramSource& source,
                                   const scene::Document& document,
                                   const analysis::Budget* budget) {
    std::vector<double> parameters = parameter_values(formula.field, document);
    shader::FieldNumbers numbers;
    if (source.precision == shader::Precision::recentred) {
        const glm::dvec3 origin = recentred_origin(document);
        numbers.origin = {origin.x, origin.y, origin.z};
        // Its parameters are the last ones: passes/recentre.h.
        parameters.insert(parameters.end(), numbers.origin.begin(), numbers.origin.end());
    }
    std::vector<double> expressions(source.expressions.roots.size());
    std::vector<double> registers;
    eval::evaluate<double>(source.expressions, {}, parameters, expressions, registers);
    FieldBounds bounds(formula.field, formula.tapes, region_of(document.bounds), parameters,
                       budget);
    std::vector<FamilyHeads> families;
    if (!source.families.empty()) {
        auto texels = std::make_shared<std::vector<float>>();
        for (const shader::FamilyTree& tree : source.family_trees) {
            const std::span tables = std::span(source.families).subspan(tree.first, tree.count);
            const analysis::Region region = region_of(tree, bounds, document.bounds);
            std::ranges::copy(add_tree(*texels, tree, tables, region, parameters, budget),
                              std::back_inserter(families));
        }
        numbers.families = std::move(texels);
    }
    std::size_t next = 0;
    for (const FieldValue& value : source.field_values) {
        const bool is_expression = value.what == FieldValue::What::expression;
        numbers.values.push_back(
            number(value, bounds, families, is_expression ? expressions[next++] : 0));
    }
    if (!source.bricks.empty() || source.scene_bricks) {
        const auto start = std::chrono::steady_clock::now();
        numbers.bricks =
            brick_texels(formula.field, formula.tapes, source.bricks, source.scene_bricks,
                         visible_region(document.bounds), parameters, budget);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        numbers.brick_seconds = taken.count();
    }
    numbers.coarse = budget && budget->was_over();
    return numbers;
}

}  // namespace compile
