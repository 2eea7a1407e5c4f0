// SPDX-License-Identifier: MIT
// The statistics of a render as JSON (`--stats`).
#pragma once

#include <optional>
#include <string>

#include "render/still.h"

namespace cli {

/// What is known besides the still itself.
struct RunFacts {
    std::string tracer, backend, renderer;
    double parse_seconds = 0;
    double analyse_seconds = 0;
    std::optional<double> evaluations;  ///< field evaluations of the primary rays
};

/// One JSON object, indented, with a newline at the end. The still needs its geometry.
std::string stats_json(const render::Still& still, const RunFacts& facts);

}  // namespace cli
