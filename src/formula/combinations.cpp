// SPDX-License-Identifier: MIT
#include "formula/combinations.h"

#include <fmt/format.h>

#include <algorithm>

#include "formula/arguments.h"
#include "formula/domain_maps.h"
#include "formula/functions.h"
#include "formula/set_operations.h"

namespace formula {
namespace {

using graph::NodeId;

std::optional<std::vector<FieldOperand>> operands(Lowering& lowering, const Call& call) {
    std::vector<FieldOperand> list;
    for (const ExpressionId id : call.arguments) {
        if (const std::optional<FieldValue> field = as_field(lowering, id)) {
            list.push_back({*field, id});
        }
    }
    if (list.size() < call.arguments.size()) return std::nullopt;
    return list;
}

bool has_count(Lowering& lowering, const Call& call, std::size_t least, std::size_t most) {
    const std::size_t count = call.arguments.size();
    if (count >= least && count <= most) return true;
    lowering.error(call.name,
                   fmt::format("'{}' takes {}{} field{}, not {}; write '{}'", call.function, least,
                               most > least ? " or more" : "", least == 1 ? "" : "s", count,
                               find_combination(call.function)->signature));
    return false;
}

Value build_union(Lowering& lowering, const Call& call) {
    const auto fields = operands(lowering, call);
    if (!has_count(lowering, call, 2, any_number) || !fields) return Nothing{};
    return unite(lowering, *fields);
}

Value build_intersection(Lowering& lowering, const Call& call) {
    const auto fields = operands(lowering, call);
    if (!has_count(lowering, call, 2, any_number) || !fields) return Nothing{};
    return intersect(lowering, *fields);
}

Value build_difference(Lowering& lowering, const Call& call) {
    const auto fields = operands(lowering, call);
    if (!has_count(lowering, call, 2, 2) || !fields) return Nothing{};
    const std::optional<FieldValue> outside = complement(lowering, (*fields)[1]);
    if (!outside) return Nothing{};
    return intersect(lowering, {(*fields)[0], {*outside, (*fields)[1].expression}});
}

Value build_complement(Lowering& lowering, const Call& call) {
    const auto fields = operands(lowering, call);
    if (!has_count(lowering, call, 1, 1) || !fields) return Nothing{};
    const std::optional<FieldValue> outside = complement(lowering, (*fields)[0]);
    if (!outside) return Nothing{};
    return *outside;
}

/// Reports an argument that is known and not above 0.
bool is_positive(Lowering& lowering, const Call& call, std::string_view argument, ExpressionId id,
                 NodeId value) {
    if (!lowering.field.graph.is_constant(value) || lowering.field.graph[value].value > 0) {
        return true;
    }
    lowering.error(lowering.span(id), fmt::format("the argument '{}' of '{}' must be above 0",
                                                  argument, call.function));
    return false;
}

Value build_smooth_union(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"", true}, {"k"}};
    const std::optional<Bound> bound = bind(lowering, call, slots, true);
    if (!bound) return Nothing{};
    const FieldOperand none{};
    FieldOperand sides[2] = {none, none};
    bool good = true;
    for (int i = 0; i < 2; ++i) {
        const std::optional<FieldValue> field = as_field(lowering, *(*bound)[i]);
        if (field) sides[i] = {*field, *(*bound)[i]};
        good = field && require_solid(lowering, sides[i], "only solids can be blended") && good;
    }
    NodeId k = lowering.field.graph.constant(0.25);
    if (const std::optional<ExpressionId> width = (*bound)[2]) {
        const auto parts = uniform_components(lowering, call, "k", *width, 1);
        if (!parts) return Nothing{};
        k = folded(lowering, (*parts)[0]);
        good = is_positive(lowering, call, "k", *width, k) && good;
    }
    if (!good) return Nothing{};
    return FieldValue{field::smooth_union(lowering.field, sides[0].field.id, sides[1].field.id, k),
                      sides[0].field.objects + sides[1].field.objects};
}

/// One argument of a map as folded components.
std::optional<std::vector<NodeId>> components(Lowering& lowering, const Call& call,
                                              std::string_view name, ExpressionId id,
                                              std::size_t count) {
    auto parts = uniform_components(lowering, call, name, id, count);
    if (parts) {
        for (NodeId& part : *parts) part = folded(lowering, part);
    }
    return parts;
}

/// `translate(F, dx, dy, dz)`, without a tuple.
Value translate_by_numbers(Lowering& lowering, const Call& call) {
    const std::optional<FieldValue> field = as_field(lowering, call.arguments[0]);
    Vector offset{};
    bool good = field.has_value();
    for (std::size_t i = 0; i < 3; ++i) {
        constexpr std::string_view names[] = {"dx", "dy", "dz"};
        const auto part = components(lowering, call, names[i], call.arguments[i + 1], 1);
        if (part) offset[i] = (*part)[0];
        good = good && part;
    }
    if (!good) return Nothing{};
    return FieldValue{translate(lowering.field, field->id, offset), field->objects};
}

Value build_translate(Lowering& lowering, const Call& call) {
    if (call.arguments.size() == 4) return translate_by_numbers(lowering, call);
    constexpr Slot slots[] = {{"", true}, {"offset", true}};
    const std::optional<Bound> bound = bind(lowering, call, slots, true);
    if (!bound) return Nothing{};
    const std::optional<FieldValue> field = as_field(lowering, *(*bound)[0]);
    const auto offset = components(lowering, call, "offset", *(*bound)[1], 3);
    if (!field || !offset) return Nothing{};
    const Vector by{(*offset)[0], (*offset)[1], (*offset)[2]};
    return FieldValue{translate(lowering.field, field->id, by), field->objects};
}

Value build_rotate(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"axis", true}, {"degrees", true}};
    const std::optional<Bound> bound = bind(lowering, call, slots, true);
    if (!bound) return Nothing{};
    const std::optional<FieldValue> field = as_field(lowering, *(*bound)[0]);
    const auto axis = components(lowering, call, "axis", *(*bound)[1], 3);
    const auto degrees = components(lowering, call, "degrees", *(*bound)[2], 1);
    if (!field || !axis || !degrees) return Nothing{};
    const graph::Graph& graph = lowering.field.graph;
    if (std::ranges::all_of(*axis, [&](NodeId id) { return graph.is_constant(id, 0); })) {
        lowering.error(lowering.span(*(*bound)[1]), "the axis of 'rotate' must not be zero");
        return Nothing{};
    }
    const Vector about{(*axis)[0], (*axis)[1], (*axis)[2]};
    return FieldValue{rotate(lowering.field, field->id, about, (*degrees)[0]), field->objects};
}

Value build_scale(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"factor", true}};
    const std::optional<Bound> bound = bind(lowering, call, slots, true);
    if (!bound) return Nothing{};
    const std::optional<FieldValue> field = as_field(lowering, *(*bound)[0]);
    const auto factor = components(lowering, call, "factor", *(*bound)[1], 1);
    if (!field || !factor) return Nothing{};
    if (!is_positive(lowering, call, "factor", *(*bound)[1], (*factor)[0])) return Nothing{};
    return FieldValue{scale(lowering.field, field->id, (*factor)[0]), field->objects};
}

constexpr Combination table[] = {
    {"complement", "complement(F)", build_complement},
    {"difference", "difference(F, G)", build_difference},
    {"intersection", "intersection(F, G, ...)", build_intersection},
    {"rotate", "rotate(F, (nx, ny, nz), degrees)", build_rotate},
    {"scale", "scale(F, factor)", build_scale},
    {"smooth_union", "smooth_union(F, G, k = 0.25)", build_smooth_union},
    {"translate", "translate(F, (dx, dy, dz))", build_translate},
    {"union", "union(F, G, ...)", build_union},
};

}  // namespace

std::span<const Combination> combinations() { return table; }

const Combination* find_combination(std::string_view name) {
    const auto* const found = std::ranges::find(table, name, &Combination::name);
    return found == std::end(table) ? nullptr : found;
}

}  // namespace formula
