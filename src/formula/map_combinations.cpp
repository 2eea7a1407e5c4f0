// SPDX-License-Identifier: MIT
// Maps of space by name.
#include <algorithm>

#include "field/cells.h"
#include "field/map_domain.h"
#include "formula/combination_arguments.h"
#include "formula/combination_builders.h"
#include "formula/domain_maps.h"
#include "formula/rotation.h"

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
    const auto axis = arguments->direction(1);
    const auto degrees = arguments->uniform(2);
    if (!a || !axis || !degrees) return Nothing{};
    return FieldValue{rotate(lowering.field, a->field.id, *axis, *degrees), a->field.objects};
}

Value build_scale(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"factor", true}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->field(0);
    const auto factor = arguments->one_or_three(1);
    if (!a || !factor) return Nothing{};
    const std::vector<NodeId>& f = *factor;
    const field::FieldId id = a->field.id;
    return FieldValue{f.size() == 1 ? scale(lowering.field, id, f[0])
                                    : scale(lowering.field, id, Vector{f[0], f[1], f[2]}),
                      a->field.objects};
}

Value build_mirror(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"normal", true}, {"d"}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->field(0);
    const auto normal = arguments->direction(1);
    const auto d = arguments->uniform(2, 0);
    if (!a || !normal || !d) return Nothing{};
    const Vector front = unit(lowering.field.graph, *normal);
    return FieldValue{field::mirror(lowering.field, a->field.id, front, *d), a->field.objects};
}

Value build_twist(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"angle", true}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->field(0);
    const auto angle = arguments->number(1);
    if (!a || !angle) return Nothing{};
    return FieldValue{field::turn_domain(lowering.field, a->field.id, *angle), a->field.objects};
}

Value build_bend(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"curvature", true}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->field(0);
    const auto curvature = arguments->uniform(1);
    if (!a || !curvature) return Nothing{};
    return FieldValue{bend(lowering.field, a->field.id, *curvature), a->field.objects};
}

Value build_map(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"m", true}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->field(0);
    const auto map = arguments->map(1);
    if (!a || !map) return Nothing{};
    return FieldValue{field::distort_domain(lowering.field, a->field.id, *map), a->field.objects};
}

Value build_repeat(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"cell", true}, {"count"}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->field(0);
    const auto cell = arguments->vector(1);
    const auto count = arguments->has(2) ? arguments->vector(2) : std::optional<Vector>();
    if (!a || !cell || (arguments->has(2) && !count)) return Nothing{};
    const graph::Graph& graph = lowering.field.graph;
    const auto negative = [&](NodeId it) { return graph.is_constant(it) && graph[it].value < 0; };
    if (std::ranges::any_of(*cell, negative)) {
        arguments->error(1, "must not be negative; 0 repeats nothing in its direction");
        return Nothing{};
    }
    return FieldValue{field::repeat(lowering.field, a->field.id, *cell, count), a->field.objects};
}

Value build_repeat_polar(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"n", true}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->field(0);
    const auto n = arguments->positive(1);
    if (!a || !n) return Nothing{};
    return FieldValue{field::repeat_polar(lowering.field, a->field.id, *n), a->field.objects};
}

}  // namespace formula
