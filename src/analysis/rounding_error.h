// SPDX-License-Identifier: MIT
// How far a formula that is evaluated in single precision may be from its exact value: running
// error analysis (Higham, "Accuracy and Stability of Numerical Algorithms", 2nd ed., 3.3) by
// intervals, over whole cells at once.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "analysis/region.h"
#include "analysis/supremum.h"
#include "eval/tape.h"
#include "numeric/interval.h"

namespace analysis {

/// What is known of a number on the GPU: its exact values for all arguments, and how far the one
/// that was computed may be from the exact one for the same arguments.
struct Rounded {
    numeric::Interval exact;
    double error = 0;  ///< +infinity if no bound is known
};

/// Evaluates a tape in single precision, for given parameters, in the order in which its GLSL does:
/// what depends on no variable is computed in double and rounded once, everything else as
/// operator_accuracy.h promises.
///
/// Rigorous given these promises, where both the exact value and the computed one are numbers: at
/// the edge of a domain rounding may leave it, and there the error is +infinity.
class RoundingErrors {
public:
    RoundingErrors(const eval::Tape& tape, std::span<const double> parameters);

    /// The values of the roots anywhere in these intervals of the variables (indexed by
    /// VariableId), whose computed values are off by up to the errors.
    std::span<const Rounded> operator()(std::span<const Rounded> variables);
    /// In a cell, where every coordinate is off by `position`.
    std::span<const Rounded> operator()(const Cell& cell, double position);

private:
    const eval::Tape& tape_;
    std::vector<Rounded> registers_, roots_;
};

/// A bound E of |computed - exact| of a formula with one root over the region, where its point is
/// off by up to `position` in every coordinate; +infinity if none was found. Rigorous as
/// RoundingErrors; too large by `effort.tolerance` or more. `parameters` is indexed by ParameterId.
double rounding_error_bound(const eval::Tape& f, const Region& region,
                            std::span<const double> parameters, double position = 0,
                            const Effort& effort = {200, 0.1, 30});

/// Half a unit in the last place of the largest coordinate in the cell, in single precision: by how
/// much rounding alone moves a point.
double position_rounding(const Cell& cell);

}  // namespace analysis
