// SPDX-License-Identifier: MIT
// A machine in single precision whose operators err as much as they may.
#pragma once

#include <random>
#include <vector>

#include "eval/tape.h"

namespace analysis {

using Random = std::mt19937_64;

/// The nearest number in single precision.
double rounded(double value);

/// What such a machine might find for the tape's first root, without parameters; by the table of
/// analysis/operator_accuracy.h. `variables` is indexed by VariableId.
double erring_value(const eval::Tape& tape, const std::vector<double>& variables, Random& random);

}  // namespace analysis
