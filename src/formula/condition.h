// SPDX-License-Identifier: MIT
// Conditions: comparisons where they do not make a field. Internal to the library.
#pragma once

#include <optional>
#include <vector>

#include "formula/lowering.h"

namespace formula {

/// A comparison of two numbers, or some of them joined by `&`, `|` and `\`. Where a number is NaN,
/// everything that is selected by the comparison is NaN.
struct Condition {
    enum class Kind { comparison, both, either } kind = Kind::comparison;
    Relation relation = Relation::less;
    graph::NodeId left{}, right{};
    bool opposite = false;         ///< holds where it would not
    std::vector<Condition> parts;  ///< of both and either
};

/// The condition that an expression says: a comparison, conditions joined by set operators, a
/// number (above 0.5 it holds), or the name of a solid given by one formula (its inside). An error
/// otherwise; nothing without one if there has been one inside.
std::optional<Condition> lower_condition(Lowering& lowering, ExpressionId id);

/// `yes` where the condition holds, else `no`.
graph::NodeId select(Lowering& lowering, const Condition& condition, graph::NodeId yes,
                     graph::NodeId no);

/// A number that is above 0 where the condition holds, and nowhere else: of `a > b` the difference,
/// of others 1 and -1.
graph::NodeId sign_of(Lowering& lowering, const Condition& condition);

}  // namespace formula
