// SPDX-License-Identifier: MIT
#include "compile/compile.h"

#include <array>
#include <cmath>

#include "analysis/leaf_bounds.h"
#include "compile/visible_region.h"
#include "formula/lower.h"
#include "passes/pipeline.h"

namespace compile {
namespace {

using shader::FieldValue;

/// Bounds by leaf, found when they are first asked for.
class Bounds {
public:
    Bounds(const Formula& formula, const scene::Document& document, std::span<const double> values)
        : formula_(formula),
          unbounded_(document.bounds.shape == scene::Bounds::Shape::none),
          region_(visible_region(document.bounds)),
          values_(values) {}

    const analysis::LeafBounds& of(field::FieldId leaf) {
        const auto found = known_.find(leaf);
        if (found != known_.end()) return found->second;
        // Rays without an end leave every region that could be bounded: the first order takes over.
        const analysis::LeafBounds bounds =
            unbounded_ ? analysis::LeafBounds{}
                       : analysis::leaf_bounds(formula_.tapes.at(leaf), region_, values_);
        return known_[leaf] = bounds;
    }

private:
    const Formula& formula_;
    bool unbounded_;
    analysis::Region region_;
    std::span<const double> values_;
    std::map<field::FieldId, analysis::LeafBounds> known_;
};

/// The number in single precision, on the safe side of the rounding.
float rounded_down(double value) { return std::nextafter(static_cast<float>(value), 0.0F); }
float rounded_up(double value) { return std::nextafter(static_cast<float>(value), INFINITY); }

float number(const FieldValue& value, Bounds& bounds, double expression) {
    if (value.what == FieldValue::What::expression) return static_cast<float>(expression);
    const analysis::LeafBounds& leaf = bounds.of(value.leaf);
    switch (value.what) {
        case FieldValue::What::expression:
            break;
        case FieldValue::What::inverse_lipschitz:
            // Across a jump or the edge of a domain no bound of derivatives says anything.
            if (leaf.partial || !std::isfinite(leaf.lipschitz)) return 0;
            return leaf.lipschitz > 0 ? rounded_down(1 / leaf.lipschitz) : 1e30F;
        case FieldValue::What::second_derivative:
            if (leaf.partial || !(leaf.second_derivative < 1e30)) return -1;
            return rounded_up(leaf.second_derivative);
        case FieldValue::What::first_order:
            return leaf.stiff || leaf.partial ? 1 : 0;
    }
    return 0;
}

}  // namespace

base::Result<Formula> compile_formula(std::string_view text) {
    auto lowered = formula::understand(text);
    if (!lowered) return lowered.problems();
    Formula formula{std::move(lowered->field), std::move(lowered->warnings), lowered->result, {}};
    passes::run(formula.field);
    for (field::FieldId id : leaves(formula.field, formula.field.root)) {
        const auto* leaf = std::get_if<field::Formula>(&formula.field[id]);
        if (leaf && (leaf->metric == field::Metric::scalar || leaf->kind == field::Kind::sheet)) {
            formula.tapes.try_emplace(
                id, eval::make_tape(formula.field.graph, std::array{leaf->value}));
        }
    }
    return formula;
}

shader::ProgramSource program_source(const Formula& formula, const scene::Document& document,
                                     shader::Outputs outputs) {
    const scene::Settings& settings = document.settings;
    shader::Features features;
    features.tracer = settings.tracer;
    features.bounds_sphere = document.bounds.shape == scene::Bounds::Shape::sphere;
    features.bounds_box = document.bounds.shape == scene::Bounds::Shape::box;
    features.shadows = settings.shadows;
    features.grid = settings.grid;
    features.show_steps = settings.show_steps;
    features.outputs = outputs;
    return shader::program_source(formula.field, features);
}

std::vector<float> field_values(const Formula& formula, const shader::ProgramSource& source,
                                const scene::Document& document) {
    const std::vector<double> parameters = parameter_values(formula.field, document);
    std::vector<double> expressions(source.expressions.roots.size());
    std::vector<double> registers;
    eval::evaluate<double>(source.expressions, {}, parameters, expressions, registers);
    Bounds bounds(formula, document, parameters);
    std::vector<float> values;
    std::size_t next = 0;
    for (const FieldValue& value : source.field_values) {
        const bool is_expression = value.what == FieldValue::What::expression;
        values.push_back(number(value, bounds, is_expression ? expressions[next++] : 0));
    }
    return values;
}

}  // namespace compile
