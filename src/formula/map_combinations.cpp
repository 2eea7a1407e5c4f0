// SPDX-License-Identifier: MIT
// Maps of space by name.
#include <algorithm>

#include "formula/combination_arguments.h"
#include "formula/combination_builders.h"
#include "formula/domain_maps.h"

namespace formula {
namespace {

using graph::NodeId;

/// `translate(F, dx, dy, dz)`, without a tuple.
Value translate_by_numbers(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"dx", true}, {"dy", true}, {"dz", true}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->field(0);
    const auto dx = arguments->uniform(1), dy = arguments->uniform(2), dz = arguments->uniform(3);
    if (!a || !dx || !dy || !dz) return Nothing{};
    return FieldValue{translate(lowering.field, a->field.id, {*dx, *dy, *dz}), a->field.objects};
}

}  // namespace

Value build_translate(Lowering& lowering, const Call& call) {
    if (call.arguments.size() == 4) return translate_by_numbers(lowering, call);
    constexpr Slot slots[] = {{"", true}, {"offset", true}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->field(0);
    const auto offset = arguments->vector(1);
    if (!a || !offset) return Nothing{};
    return FieldValue{translate(lowering.field, a->field.id, *offset), a->field.objects};
}

Value build_rotate(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"axis", true}, {"degrees", true}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->field(0);
    const auto axis = arguments->vector(1);
    const auto degrees = arguments->uniform(2);
    if (!a || !axis || !degrees) return Nothing{};
    if (std::ranges::all_of(*axis, [&](NodeId id) { return arguments->is_constant(id, 0); })) {
        lowering.error(arguments->span(1), "the axis of 'rotate' must not be zero");
        return Nothing{};
    }
    return FieldValue{rotate(lowering.field, a->field.id, *axis, *degrees), a->field.objects};
}

Value build_scale(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"factor", true}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->field(0);
    const auto factor = arguments->positive(1);
    if (!a || !factor) return Nothing{};
    return FieldValue{scale(lowering.field, a->field.id, *factor), a->field.objects};
}

}  // namespace formula
