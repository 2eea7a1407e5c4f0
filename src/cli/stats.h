// SPDX-License-Identifier: MIT
// The statistics of a render as JSON (`--stats`).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compile/step_rules.h"
#include "render/still.h"
#include "shader/field_numbers.h"

namespace cli {

/// What is known besides the still itself.
struct RunFacts {
    std::string tracer, backend, renderer;
    std::string precision, precision_reason;
    double parse_seconds = 0;
    double analyse_seconds = 0;
    std::vector<compile::StepRule> rules;
    std::shared_ptr<const shader::BrickTexels> bricks;  ///< if the program reads any
    double brick_seconds = 0;
};

/// One JSON object, indented, with a newline at the end. The still needs its geometry; `counted` is
/// one of a program that counts evaluations and certificates.
std::string stats_json(const render::Still& still, const render::Still& counted,
                       const RunFacts& facts);

}  // namespace cli
