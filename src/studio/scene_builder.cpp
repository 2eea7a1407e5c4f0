// SPDX-License-Identifier: MIT
#include "studio/scene_builder.h"

#include <exception>
#include <utility>

#include <fmt/format.h>

#include "compile/check_scene.h"
#include "compile/step_rules.h"
#include "studio/live_outputs.h"

namespace studio {
namespace {

/// Whether compile::field_numbers reads the same of both.
bool reads_alike(const scene::Document& a, const scene::Document& b) {
    return a.parameters == b.parameters && a.time == b.time && a.bounds == b.bounds;
}

/// Below 1 the scale makes steps longer than they are proven to be: then that is counted.
shader::Outputs outputs_for(const scene::Document& document) {
    shader::Outputs outputs = live_outputs;
    outputs.certificate = document.settings.lipschitz < 1;
    return outputs;
}

}  // namespace

std::optional<BuiltScene> SceneBuilder::build(const scene::Document& document,
                                              const std::function<bool()>& superseded,
                                              const analysis::Budget* budget) {
    try {
        return build_throwing({document, superseded, budget});
    } catch (const std::exception& exception) {
        BuiltScene built;
        built.text = document.formula;
        built.diagnostics = diagnostics_;
        built.failures.push_back(base::error(fmt::format(
            "internal error while compiling: {}; change the formula", exception.what())));
        return built;
    }
}

std::optional<BuiltScene> SceneBuilder::build_throwing(const Wanted& wanted) {
    const scene::Document& document = wanted.document;
    if (text_ != document.formula) {
        if (wanted.superseded()) return std::nullopt;
        read(document.formula);
    }
    BuiltScene built;
    built.text = *text_;
    built.diagnostics = diagnostics_;
    if (!make_drawable(wanted, built)) return std::nullopt;
    if (drawn_) {
        update_numbers(wanted);
        built.field_numbers = drawn_->numbers;
        built.bounds = document.bounds;
        built.steps = compile::summary(
            compile::step_rules(drawn_->formula.field, drawn_->source, drawn_->numbers, document));
        if (is_coarse()) built.steps += "; bounds are still coarse";
        built.precision = drawn_->precision;
    }
    return built;
}

/// Analyses run only where something has changed that they read, or where they had no time.
void SceneBuilder::update_numbers(const Wanted& wanted) {
    const bool alike = reads_alike(drawn_->numbers_of, wanted.document);
    if (alike && !drawn_->numbers.coarse) return;
    shader::FieldNumbers numbers =
        compile::field_numbers(drawn_->formula, drawn_->source, wanted.document, wanted.budget);
    ++work_.analyses;
    if (alike && numbers.coarse) return;
    drawn_->numbers = std::move(numbers);
    drawn_->numbers_of = wanted.document;
}

void SceneBuilder::read(const std::string& text) {
    text_ = text;
    diagnostics_.clear();
    candidate_.reset();
    auto formula = compile::compile_formula(text);
    understood_ = static_cast<bool>(formula);
    if (!understood_) {
        diagnostics_ = formula.problems();
        return;
    }
    diagnostics_ = formula->warnings;
    candidate_ = std::move(*formula);
}

/// Links a program if another one is needed. False if it was left because of a newer request.
bool SceneBuilder::make_drawable(const Wanted& wanted, BuiltScene& built) {
    const scene::Document& document = wanted.document;
    const compile::Formula* formula = candidate_ ? &*candidate_ : this->formula();
    if (!formula) return true;
    if (understood_) {
        built.parameters = formula->field.parameters;
        const base::Diagnostics warnings = compile::check_scene(*formula, document);
        built.diagnostics.insert(built.diagnostics.end(), warnings.begin(), warnings.end());
    }
    compile::PrecisionChoice precision = compile::choose_precision(*formula, document);
    shader::Features features = compile::features(*formula, document, outputs_for(document));
    features.precision = precision.precision;
    if (!candidate_ && drawn_ && features == drawn_->features) {
        drawn_->precision = std::move(precision);
        return true;
    }
    shader::ProgramSource source = shader::program_source(formula->field, features);
    ++work_.sources;
    const bool another = !drawn_ || !source.same_text(drawn_->source);
    if (another && rejected_ && source.same_text(*rejected_)) {
        built.failures = rejection_;
        return true;
    }
    if (!another && !candidate_) return true;
    if (another && wanted.superseded()) return false;
    Drawn next{*formula, std::move(features), std::move(precision), std::move(source)};
    next.numbers = compile::field_numbers(next.formula, next.source, document, wanted.budget);
    next.numbers_of = document;
    ++work_.analyses;
    if (another) {
        auto program = link_(next.source);
        if (!program) {
            rejected_ = std::move(next.source);
            rejection_ = program.problems();
            built.failures = rejection_;
            return true;
        }
        ++work_.links;
        built.program = std::move(*program);
    }
    candidate_.reset();
    drawn_ = std::move(next);
    return true;
}

}  // namespace studio
