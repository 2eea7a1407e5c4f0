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
                                              const std::function<bool()>& superseded) {
    try {
        return build_throwing(document, superseded);
    } catch (const std::exception& exception) {
        BuiltScene built;
        built.text = document.formula;
        built.diagnostics = diagnostics_;
        built.failures.push_back(base::error(fmt::format(
            "internal error while compiling: {}; change the formula", exception.what())));
        return built;
    }
}

std::optional<BuiltScene> SceneBuilder::build_throwing(const scene::Document& document,
                                                       const std::function<bool()>& superseded) {
    if (text_ != document.formula) {
        if (superseded()) return std::nullopt;
        read(document.formula);
    }
    BuiltScene built;
    built.text = *text_;
    built.diagnostics = diagnostics_;
    if (!make_drawable(document, built, superseded)) return std::nullopt;
    if (drawn_) {
        built.field_numbers = numbers_of_drawn(document);
        built.bounds = document.bounds;
        built.steps = compile::summary(compile::step_rules(drawn_->formula.field, drawn_->source,
                                                           *built.field_numbers, document));
        built.precision = compile::choose_precision(drawn_->formula, document);
        built.precision.precision = drawn_->source.precision;
    }
    return built;
}

/// Analyses run only where something has changed that they read.
const shader::FieldNumbers& SceneBuilder::numbers_of_drawn(const scene::Document& document) {
    if (!reads_alike(drawn_->numbers_of, document)) {
        drawn_->numbers = compile::field_numbers(drawn_->formula, drawn_->source, document);
        drawn_->numbers_of = document;
        ++work_.analyses;
    }
    return drawn_->numbers;
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
bool SceneBuilder::make_drawable(const scene::Document& document, BuiltScene& built,
                                 const std::function<bool()>& superseded) {
    const compile::Formula* formula = candidate_ ? &*candidate_ : this->formula();
    if (!formula) return true;
    if (understood_) {
        built.parameters = formula->field.parameters;
        const base::Diagnostics warnings = compile::check_scene(*formula, document);
        built.diagnostics.insert(built.diagnostics.end(), warnings.begin(), warnings.end());
    }
    shader::ProgramSource source =
        compile::program_source(*formula, document, outputs_for(document));
    const bool another = !drawn_ || !source.same_text(drawn_->source);
    if (another && rejected_ && source.same_text(*rejected_)) {
        built.failures = rejection_;
        return true;
    }
    if (!another && !candidate_) return true;
    if (another && superseded()) return false;
    Drawn next{.formula = *formula, .source = std::move(source)};
    next.numbers = compile::field_numbers(next.formula, next.source, document);
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
