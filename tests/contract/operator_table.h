// SPDX-License-Identifier: MIT
// What is promised of each operator in single precision: for which arguments, and how exact.
#pragma once

#include <array>
#include <span>

#include "graph/operator.h"

namespace contract {

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

struct Row {
    graph::Op op{};
    std::array<Range, graph::max_arity> ranges{};  ///< of the arguments
    Unit unit = Unit::relative;
    double bound = 0;  ///< no error is larger, in these units
};

/// Arguments of one operator, in single precision from the start, so that all evaluators see the
/// same numbers; those beyond its arity do not count.
using Arguments = std::array<float, graph::max_arity>;

std::span<const Row> operator_table();

/// The row of an operator; null if the table has none.
const Row* find_row(graph::Op op);

/// True where an operator's precondition holds: for others nothing at all is promised.
bool is_allowed(graph::Op op, const Arguments& arguments);

/// Beside the square of the largest argument of a length those that vanish must not count: it is at
/// least this.
inline constexpr double least_length = 1e-15;

/// True where the row's bound is promised.
bool is_promised(const Row& row, const Arguments& arguments);

/// The unit's size for these arguments of the operator and its value.
double size_of(Unit unit, const Arguments& arguments, double value);

/// The unit in words, for messages.
const char* name_of(Unit unit);

}  // namespace contract
