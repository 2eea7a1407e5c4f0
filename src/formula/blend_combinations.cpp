// SPDX-License-Identifier: MIT
// Blends of fields by name.
#include <algorithm>
#include <vector>

#include "field/blends.h"
#include "formula/combination_arguments.h"
#include "formula/combination_builders.h"
#include "formula/repeated_field.h"

namespace formula {
namespace {

using field::FieldId;
using graph::NodeId;

constexpr std::string_view only_solids = "only solids can be blended";

using Pair = FieldId (*)(field::Field&, FieldId, FieldId, NodeId);

/// Two fields and a number above 0.
Value build_pair(Lowering& lowering, const Call& call, std::string_view number, double initial,
                 Pair build) {
    const Slot slots[] = {{"", true}, {"", true}, {number}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->solid(0, only_solids);
    const auto b = arguments->solid(1, only_solids);
    const auto k = arguments->positive(2, initial);
    if (!a || !b || !k) return Nothing{};
    return FieldValue{build(lowering.field, a->field.id, b->field.id, *k),
                      a->field.objects + b->field.objects};
}

Value smooth_union_of(Lowering& lowering, const std::vector<FieldOperand>& operands,
                      std::optional<NodeId> k) {
    std::vector<FieldId> ids;
    std::size_t objects = 0;
    for (const FieldOperand& it : operands) {
        if (!require_solid(lowering, it, only_solids)) return Nothing{};
        ids.push_back(it.field.id);
        objects += it.field.objects;
    }
    if (!k) return Nothing{};
    return FieldValue{field::smooth_union(lowering.field, ids, *k), objects};
}

}  // namespace

Value build_smooth_union(Lowering& lowering, const Call& call) {
    if (has_repeated_field(lowering, call)) {
        constexpr Slot slots[] = {{"", true}, {"n", true}, {"k"}};
        const auto arguments = CombinationArguments::of(lowering, call, slots);
        const auto copies = arguments ? repeated_field(lowering, call) : std::nullopt;
        return copies ? smooth_union_of(lowering, *copies, arguments->positive(2, 0.25))
                      : Nothing{};
    }
    // The last of three or more arguments may be a field or the width.
    const std::size_t most = std::max<std::size_t>(call.arguments.size(), 2);
    for (std::size_t fields = std::max<std::size_t>(most - 1, 2); fields <= most; ++fields) {
        std::vector<Slot> slots(fields, {"", true});
        slots.push_back({"k"});
        const auto arguments = CombinationArguments::of(lowering, call, slots);
        if (!arguments) return Nothing{};
        if (fields < most && arguments->is_field(fields)) continue;
        std::vector<FieldOperand> operands;
        for (std::size_t i = 0; i < fields; ++i) {
            const auto operand = arguments->solid(i, only_solids);
            if (operand) operands.push_back(*operand);
        }
        const auto k = arguments->positive(fields, 0.25);
        if (operands.size() < fields) return Nothing{};
        return smooth_union_of(lowering, operands, k);
    }
    return Nothing{};
}

Value build_smooth_union_exp(Lowering& lowering, const Call& call) {
    return build_pair(lowering, call, "k", 8, field::smooth_union_exp);
}

Value build_smooth_union_power(Lowering& lowering, const Call& call) {
    return build_pair(lowering, call, "p", 4, field::smooth_union_power);
}

Value build_smooth_intersection(Lowering& lowering, const Call& call) {
    return build_pair(lowering, call, "k", 0.25, field::smooth_intersection);
}

Value build_smooth_difference(Lowering& lowering, const Call& call) {
    return build_pair(lowering, call, "k", 0.25, field::smooth_difference);
}

Value build_offset(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"d", true}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->solid(0, "only solids have an offset");
    const auto d = arguments->uniform(1);
    if (!a || !d) return Nothing{};
    return FieldValue{field::offset(lowering.field, a->field.id, *d), a->field.objects};
}

Value build_shell(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"thickness"}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->solid(0, "only solids have a shell");
    const auto thickness = arguments->positive(1, 0.1);
    if (!a || !thickness) return Nothing{};
    return FieldValue{field::shell(lowering.field, a->field.id, *thickness), a->field.objects};
}

Value build_displace(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"by", true}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->solid(0, "only solids can be displaced");
    const auto by = arguments->number(1);
    if (!a || !by) return Nothing{};
    return FieldValue{field::displace(lowering.field, a->field.id, *by), a->field.objects};
}

Value build_morph(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"", true}, {"t", true}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->solid(0, only_solids);
    const auto b = arguments->solid(1, only_solids);
    const auto t = arguments->uniform(2);
    if (!a || !b || !t) return Nothing{};
    return FieldValue{field::morph(lowering.field, a->field.id, b->field.id, *t),
                      a->field.objects + b->field.objects};
}

}  // namespace formula
