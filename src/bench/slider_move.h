// SPDX-License-Identifier: MIT
// How long a slider's move takes to become a picture.
#pragma once

#include <functional>
#include <optional>

#include "bench/report.h"
#include "compile/compile.h"

namespace bench {

/// Moves the first number among the formula's parameters to and fro by a hundredth of its range,
/// and does each time what the studio does: checks, analyses within a frame's budget, and draws.
/// None if there is no such parameter. `draw` draws with these numbers and waits for the picture.
std::optional<SliderMove> move_slider(const compile::Formula& formula,
                                      const shader::ProgramSource& source,
                                      const scene::Document& document,
                                      const std::function<void(shader::FieldNumbers)>& draw);

}  // namespace bench
