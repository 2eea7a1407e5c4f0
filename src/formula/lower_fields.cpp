// SPDX-License-Identifier: MIT
// Lowers the chains of set operators.
#include "formula/set_operations.h"

namespace formula {

Value lower_union(Lowering& lowering, const Union& chain) {
    std::vector<FieldOperand> operands;
    for (const Operand& operand : chain.operands) {
        const std::optional<FieldValue> field = as_field(lowering, operand.expression);
        if (field) operands.push_back({*field, operand.expression});
    }
    if (operands.size() < chain.operands.size()) return Nothing{};
    return unite(lowering, operands);
}

Value lower_intersection(Lowering& lowering, const Intersection& chain) {
    std::vector<FieldOperand> operands;
    for (const Operand& operand : chain.operands) {
        std::optional<FieldValue> field = as_field(lowering, operand.expression);
        if (field && operand.joint == Joint::without) {
            field = complement(lowering, {*field, operand.expression});
        }
        if (field) operands.push_back({*field, operand.expression});
    }
    if (operands.size() < chain.operands.size()) return Nothing{};
    return intersect(lowering, operands);
}

}  // namespace formula
