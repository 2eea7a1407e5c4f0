// SPDX-License-Identifier: MIT
// Tapes at many points at once, in double precision.
#pragma once

#include <span>
#include <vector>

#include "eval/tape.h"

namespace eval {

/// So many points go through the tape together, each instruction for all of them before the next.
inline constexpr std::size_t block_size = 128;

/// Evaluates the roots at many points. `variables` (indexed by VariableId) has a list of
/// coordinates for each variable that the tape needs, `roots` a list for each root; all lists have
/// the same length. `registers` were filled by load_parameters for this tape and are not changed.
/// The results are bit for bit those of evaluate_loaded. `scratch` may hold anything; keeping it
/// between calls saves allocations.
void evaluate_points(const Tape& tape, std::span<const double> registers,
                     std::span<const std::span<const double>> variables,
                     std::span<const std::span<double>> roots, std::vector<double>& scratch);

}  // namespace eval
