// SPDX-License-Identifier: MIT
#include "studio/scene_builder.h"

#include <exception>
#include <utility>

#include <fmt/format.h>

#include "compile/check_scene.h"

namespace studio {
namespace {

constexpr shader::Outputs live_outputs{.picture = true, .geometry = true};

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
        built.field_numbers = compile::field_numbers(drawn_->formula, drawn_->source, document);
        built.bounds = document.bounds;
    }
    return built;
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
    shader::ProgramSource source = compile::program_source(*formula, document, live_outputs);
    const bool another = !drawn_ || !source.same_text(drawn_->source);
    if (another && rejected_ && source.same_text(*rejected_)) {
        built.failures = rejection_;
        return true;
    }
    if (another) {
        if (superseded()) return false;
        auto program = link_(source, document, compile::field_numbers(*formula, source, document));
        if (!program) {
            rejected_ = source;
            rejection_ = program.problems();
            built.failures = rejection_;
            return true;
        }
        built.program = std::move(*program);
    }
    compile::Formula kept = candidate_ ? std::move(*candidate_) : std::move(drawn_->formula);
    candidate_.reset();
    drawn_ = Drawn{std::move(kept), std::move(source)};
    return true;
}

}  // namespace studio
