// SPDX-License-Identifier: MIT
// The facade over the whole chain: a formula's text becomes a field, a field and settings become a
// program's source, a field and parameter values become the numbers that the program is fed with.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/budget.h"
#include "base/result.h"
#include "compile/field_bounds.h"
#include "compile/parameter_values.h"
#include "eval/tape.h"
#include "field/field.h"
#include "scene/document.h"
#include "shader/field_numbers.h"
#include "shader/program_source.h"

namespace compile {

/// A formula that is understood: parsed, lowered, and passed through all passes.
struct Formula {
    field::Field field;
    base::Diagnostics warnings;
    base::SourceSpan result;  ///< the last expression, whose field this is
    /// Leaves that are comparisons as they stand in the text.
    std::map<field::FieldId, base::SourceSpan> comparisons;
    BoundTapes tapes;
    std::vector<field::FieldId> bricks;  ///< leaves that are known brick by brick
};

/// Spans are bytes of the text. All problems are reported, not only the first.
base::Result<Formula> compile_formula(std::string_view text);

/// What of a formula and a document changes the program beside the field; the precision is left
/// as it is by default.
shader::Features features(const Formula& formula, const scene::Document& document,
                          const shader::Outputs& outputs);

/// The program that draws this document's picture; depends on the formula and on what is switched
/// on, never on a parameter's value, but for the precision that is chosen (compile/precision.h).
/// `outputs` says what is written per pixel.
shader::ProgramSource program_source(const Formula& formula, const scene::Document& document,
                                     shader::Outputs outputs);

/// The numbers of one frame that come from the formula: hoisted expressions and bounds of
/// derivatives, in the order of ProgramSource::field_values. Runs the analyses, as far as the
/// budget goes; without one milliseconds, and the same each time.
shader::FieldNumbers field_numbers(const Formula& formula, const shader::ProgramSource& source,
                                   const scene::Document& document,
                                   const analysis::Budget* budget = nullptr);

}  // namespace compile
