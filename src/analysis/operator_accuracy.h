// SPDX-License-Identifier: MIT
// What is promised of each operator in single precision as the shaders compute it: for which
// arguments, and how exact.
#pragma once

#include <array>
#include <span>

#include "graph/operator.h"
#include "numeric/interval.h"

namespace analysis {

/// All numbers from `low` to `high`.
struct Range {
    double low = 0;
    double high = 0;

    bool contains(double number) const { return low <= number && number <= high; }
};

/// What an error is counted in.
enum class Unit {
    none,      ///< there is no error
    relative,  ///< parts of the value
    absolute,  ///< parts of 1
    mixed,     ///< parts of the value or of 1, whichever is larger
    slope,     ///< of a tangent: parts of its derivative, 1 + value^2
    power,     ///< of a^b: parts of the value, times 1 + |b| + |log value|
};

/// Of one operator: arguments within the ranges make no error that is larger than the bound. A
/// promise of ours, not of GLSL, about twice what was found with llvmpipe; the contract test holds
/// it.
struct Accuracy {
    graph::Op op{};
    std::array<Range, graph::max_arity> ranges{};  ///< of the arguments
    Unit unit = Unit::relative;
    double bound = 0;  ///< in these units
};

/// Of all operators.
std::span<const Accuracy> operator_accuracies();

/// Of one operator; null if the table has none.
const Accuracy* accuracy_of(graph::Op op);

/// Beside the square of the largest argument of a length those that vanish must not count: it is at
/// least this.
inline constexpr double least_length = 1e-15;

/// True where the promise is given: for all arguments in these intervals, those beyond the
/// operator's arity not looked at.
bool is_promised(const Accuracy& accuracy,
                 const std::array<numeric::Interval, graph::max_arity>& arguments);

/// The unit's size for a value; `exponent` is the second argument of a power.
double size_of(Unit unit, double exponent, double value);
/// The largest size for values in an interval and exponents in another.
double largest_size(Unit unit, const numeric::Interval& exponent, const numeric::Interval& value);

}  // namespace analysis
