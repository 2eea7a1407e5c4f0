// SPDX-License-Identifier: MIT
// A logarithmic axis of a plot.
#pragma once

#include <span>
#include <vector>

namespace studio {

/// Ends at numbers that are 1, 2 or 5 times a power of ten. Where it has a zero, that has a place
/// of its own at the low end.
struct LogAxis {
    static constexpr double zero_share = 0.12;

    double low = 1, high = 10;
    bool zero = false;

    /// 0 at the low end, 1 at the high one; what is outside is put on the end. Zero and what is
    /// below it are at 0 where the axis has a zero.
    double place(double value) const;
    /// From low to high: all that are 1, 2 or 5 times a power of ten, or only the powers of ten
    /// where those would be more than 7.
    std::vector<double> ticks() const;
};

/// The shortest axis that has all positive values on it, and no shorter than from one such number
/// to the next.
LogAxis log_axis(std::span<const double> values, bool zero);

}  // namespace studio
