// SPDX-License-Identifier: MIT
// Turns documents into what the live picture needs, and remembers the last good formula, so that a
// broken text does not take the picture away.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/budget.h"
#include "base/result.h"
#include "compile/compile.h"
#include "compile/precision.h"
#include "render/program.h"
#include "scene/document.h"

namespace studio {

/// What the compiler says about a document.
struct BuiltScene {
    std::string text;               ///< the formula that the diagnostics speak of
    base::Diagnostics diagnostics;  ///< of the formula: errors, or else warnings
    base::Diagnostics failures;     ///< of the driver, or of ourselves
    /// The sliders of the formula; none if the text was not understood.
    std::optional<std::vector<field::Parameter>> parameters;

    /// A program, if it is another one than before.
    std::unique_ptr<render::Program> program;
    /// The numbers of the newest program, and the bounds that they hold for; none if nothing can be
    /// drawn.
    std::optional<shader::FieldNumbers> field_numbers;
    scene::Bounds bounds;
    std::string steps;  ///< how they are found, and how sure that is: compile::summary
    compile::PrecisionChoice precision;
};

/// How much work building was, since the beginning.
struct BuildWork {
    int links = 0;     ///< programs
    int sources = 0;   ///< texts of programs
    int analyses = 0;  ///< of the field over the region: its numbers
};

/// Compiles one document after the other, redoing only what has changed. Used by one thread, with a
/// context current if `link` needs one.
class SceneBuilder {
public:
    using Link = std::function<base::Result<std::unique_ptr<render::Program>>(
        const shader::ProgramSource& source)>;

    explicit SceneBuilder(Link link) : link_(std::move(link)) {}

    /// `superseded` is asked before anything slow; where it says yes, the document is left as it
    /// is, and nothing is answered. Exceptions from below come back as failures. Analyses end when
    /// the budget is over (null: never); building the same document again goes on from there.
    std::optional<BuiltScene> build(const scene::Document& document,
                                    const std::function<bool()>& superseded,
                                    const analysis::Budget* budget = nullptr);

    /// Whether the newest numbers would be closer if there had been more time.
    bool is_coarse() const { return drawn_ && drawn_->numbers.coarse; }

    const BuildWork& work_done() const { return work_; }
    /// The formula of the picture; none before the first good one.
    const compile::Formula* formula() const { return drawn_ ? &drawn_->formula : nullptr; }

private:
    struct Drawn {
        compile::Formula formula;
        shader::Features features;
        compile::PrecisionChoice precision;
        shader::ProgramSource source;
        shader::FieldNumbers numbers{};
        scene::Document numbers_of{};
    };

    /// What a document asks for.
    struct Wanted {
        const scene::Document& document;
        const std::function<bool()>& superseded;
        const analysis::Budget* budget;
    };

    void update_numbers(const Wanted& wanted);
    std::optional<BuiltScene> build_throwing(const Wanted& wanted);
    void read(const std::string& text);
    bool make_drawable(const Wanted& wanted, BuiltScene& built);

    Link link_;
    BuildWork work_;
    std::optional<std::string> text_;  ///< the text that was read last
    base::Diagnostics diagnostics_;
    bool understood_ = false;
    std::optional<compile::Formula> candidate_;      ///< good, but not drawn yet
    std::optional<Drawn> drawn_;                     ///< what the newest program draws
    std::optional<shader::ProgramSource> rejected_;  ///< what the driver did not accept
    base::Diagnostics rejection_;                    ///< and why
};

}  // namespace studio
