// SPDX-License-Identifier: MIT
#include "formula/set_operations.h"

#include <fmt/format.h>

#include <span>

namespace formula {
namespace {

bool is_sheet(const Lowering& lowering, const FieldOperand& operand) {
    return field::kind_of(lowering.field, operand.field.id) == field::Kind::sheet;
}

/// How to make a solid of the sheet that an expression describes.
std::string_view solid_hint(const Lowering& lowering, ExpressionId id) {
    const ExpressionNode& node = lowering[id].node;
    if (std::holds_alternative<Comparison>(node)) return "write '<=' instead of '='";
    return "write 'F <= 0' for the solid of a formula F";
}

template <class Node>
FieldValue balance(Lowering& lowering, std::span<const FieldOperand> operands) {
    if (operands.size() == 1) return operands[0].field;
    const std::size_t half = operands.size() / 2;
    const FieldValue a = balance<Node>(lowering, operands.first(half));
    const FieldValue b = balance<Node>(lowering, operands.subspan(half));
    return {lowering.field.add(Node{a.id, b.id}), a.objects + b.objects};
}

}  // namespace

bool require_solid(Lowering& lowering, const FieldOperand& operand, std::string_view problem) {
    if (!is_sheet(lowering, operand)) return true;
    lowering.error(lowering.span(operand.expression),
                   fmt::format("{}; {}", problem, solid_hint(lowering, operand.expression)));
    return false;
}

FieldValue unite(Lowering& lowering, const std::vector<FieldOperand>& operands) {
    return balance<field::Union>(lowering, operands);
}

Value intersect(Lowering& lowering, const std::vector<FieldOperand>& operands) {
    bool sheet = false;
    for (const FieldOperand& operand : operands) {
        if (sheet && !require_solid(lowering, operand,
                                    "two sheets intersect in a curve, which has no surface")) {
            return Nothing{};
        }
        sheet = sheet || is_sheet(lowering, operand);
    }
    return balance<field::Intersection>(lowering, operands);
}

std::optional<FieldValue> complement(Lowering& lowering, const FieldOperand& operand) {
    if (!require_solid(lowering, operand, "a sheet has no inside, so it has no complement")) {
        return std::nullopt;
    }
    const field::Node& node = lowering.field[operand.field.id];
    if (const auto* inner = std::get_if<field::Complement>(&node)) {
        return FieldValue{inner->a, operand.field.objects};
    }
    return FieldValue{lowering.field.add(field::Complement{operand.field.id}),
                      operand.field.objects};
}

}  // namespace formula
