// SPDX-License-Identifier: MIT
#include "analysis/operand_choice.h"

#include <algorithm>
#include <array>

namespace analysis {
namespace {

/// The least of them; what is undefined does not count.
double least_of(std::span<const double> values) {
    // Four at a time do not wait for one another.
    std::array<double, 4> least{INFINITY, INFINITY, INFINITY, INFINITY};
    for (std::size_t i = 0; i + 4 <= values.size(); i += 4) {
        for (std::size_t k = 0; k < 4; ++k) {
            least[k] = values[i + k] < least[k] ? values[i + k] : least[k];
        }
    }
    for (std::size_t i = values.size() / 4 * 4; i < values.size(); ++i) {
        least[0] = values[i] < least[0] ? values[i] : least[0];
    }
    return *std::ranges::min_element(least);
}

/// The polynomial smooth minimum (field::smooth_union).
double smooth_minimum(double a, double b, double width) {
    const double overlap = std::max(width - std::abs(a - b), 0.0) / width;
    return std::min(a, b) - overlap * overlap * width / 4;
}

/// An operand that is by n widths farther than another changes the smooth minimum by at most
/// exp(-2 (n - 2)) / 4 widths: while that sinks by a width, what it owes to earlier operands
/// becomes smaller by more than exp(-2). So that is less than 3e-8.
constexpr double most_widths = 10;

}  // namespace

/// The places of those that are not above the bound; what is undefined is not.
OperandSpan OperandChoice::places_below(std::span<const double> values, double bound) {
    places_.resize(values.size() + 1);
    std::size_t count = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        // Without a branch, which no processor could foresee.
        places_[count] = static_cast<std::uint32_t>(i);
        count += !(values[i] > bound);
    }
    return std::span(places_).first(count);
}

OperandChoice::Found OperandChoice::nearest(const OperandList& list, std::span<const double> values,
                                            double reach) {
    const double least = least_of(values);
    const OperandSpan places = places_below(values, least + 2 * reach);
    kept_.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) kept_[i] = list[places[i]];
    return {least, kept_};
}

/// What is farther than the width from the minimum so far changes nothing, and if it is so much
/// smaller then all before it change nothing. The minimum so far is 1-Lipschitz as well.
OperandChoice::Found OperandChoice::blended(const OperandList& list, std::span<const double> values,
                                            double reach, double width) {
    const double far = least_of(values) + 2 * reach + most_widths * width;
    const double overlap = width + 2 * reach;
    double least = INFINITY;
    kept_.resize(list.size());
    std::size_t count = 0;
    for (const std::uint32_t i : places_below(values, far)) {
        const double value = values[i];
        if (value >= least + overlap) continue;
        if (value + overlap <= least) count = 0;
        least = count == 0 ? value : smooth_minimum(least, value, width);
        kept_[count++] = list[i];
    }
    return {least, std::span(kept_).first(count)};
}

}  // namespace analysis
