// SPDX-License-Identifier: MIT
// Which operands of a minimum can matter around a point where their values are known.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "analysis/operand_values.h"

namespace analysis {

/// Some operands that somebody else keeps.
using OperandSpan = std::span<const std::uint32_t>;

/// Chooses operands that are 1-Lipschitz from a list. Keeps room between calls; for one thread.
class OperandChoice {
public:
    /// The operands, in their order, hold until the next call.
    struct Found {
        double least = INFINITY;  ///< the minimum at the point
        OperandSpan operands;
    };

    /// Those that can be the smallest somewhere within the reach of the point with these values.
    Found nearest(const OperandList& list, std::span<const double> values, double reach);

    /// Those that a polynomial smooth minimum is made of, one after the other, within the reach of
    /// the point, to 3e-8 of the width.
    Found blended(const OperandList& list, std::span<const double> values, double reach,
                  double width);

private:
    OperandSpan places_below(std::span<const double> values, double bound);

    std::vector<std::uint32_t> places_;
    OperandList kept_;
};

}  // namespace analysis
