// SPDX-License-Identifier: MIT
#include "formula/combination_arguments.h"

#include <fmt/format.h>

#include <algorithm>

#include "field/palette.h"
#include "formula/apply.h"

namespace formula {

using graph::NodeId;

std::optional<CombinationArguments> CombinationArguments::of(Lowering& lowering, const Call& call,
                                                             std::span<const Slot> slots) {
    std::optional<Bound> bound = bind(lowering, call, slots, true);
    if (!bound) return std::nullopt;
    return CombinationArguments(lowering, call, slots, std::move(*bound));
}

std::string CombinationArguments::subject(std::size_t slot) const {
    return fmt::format("the argument '{}' of '{}'", slots_[slot].name, call_.function);
}

void CombinationArguments::error(std::size_t slot, std::string_view message) const {
    lowering_.error(span(slot), fmt::format("{} {}", subject(slot), message));
}

std::optional<FieldOperand> CombinationArguments::field(std::size_t slot) const {
    const std::optional<FieldValue> field = as_field(lowering_, *bound_[slot]);
    if (!field) return std::nullopt;
    return FieldOperand{*field, *bound_[slot]};
}

bool CombinationArguments::is_field(std::size_t slot) const {
    return has(slot) &&
           std::holds_alternative<FieldValue>(lower_expression(lowering_, *bound_[slot]));
}

std::optional<FieldOperand> CombinationArguments::solid(std::size_t slot,
                                                        std::string_view problem) const {
    std::optional<FieldOperand> operand = field(slot);
    if (operand && !require_solid(lowering_, *operand, problem)) return std::nullopt;
    return operand;
}

std::optional<NodeId> CombinationArguments::number(std::size_t slot) const {
    return as_number(lowering_, *bound_[slot], "as " + subject(slot));
}

std::optional<std::vector<NodeId>> CombinationArguments::components(std::size_t slot,
                                                                    std::size_t count,
                                                                    bool may_be_one) const {
    auto parts =
        uniform_components(lowering_, call_, slots_[slot].name, *bound_[slot], count, may_be_one);
    if (!parts) return std::nullopt;
    for (NodeId& part : *parts) part = folded(lowering_, part);
    return parts;
}

std::optional<NodeId> CombinationArguments::uniform(std::size_t slot,
                                                    std::optional<double> initial) const {
    if (!has(slot)) return lowering_.field.graph.constant(*initial);
    const auto parts = components(slot, 1);
    if (!parts) return std::nullopt;
    return (*parts)[0];
}

std::optional<NodeId> CombinationArguments::positive(std::size_t slot,
                                                     std::optional<double> initial) const {
    const std::optional<NodeId> number = uniform(slot, initial);
    if (!number || !is_positive(slot, *number)) return std::nullopt;
    return number;
}

bool CombinationArguments::is_positive(std::size_t slot, NodeId number) const {
    const graph::Graph& graph = lowering_.field.graph;
    if (!graph.is_constant(number) || graph[number].value > 0) return true;
    error(slot, "must be above 0");
    return false;
}

std::optional<std::vector<NodeId>> CombinationArguments::one_or_three(std::size_t slot) const {
    auto parts = components(slot, 3, true);
    if (!parts) return std::nullopt;
    for (const NodeId part : *parts) {
        if (!is_positive(slot, part)) return std::nullopt;
    }
    return parts;
}

std::optional<Vector> CombinationArguments::direction(std::size_t slot) const {
    const std::optional<Vector> parts = vector(slot);
    if (!parts) return std::nullopt;
    const graph::Graph& graph = lowering_.field.graph;
    if (std::ranges::all_of(*parts, [&](NodeId id) { return graph.is_constant(id, 0); })) {
        lowering_.error(span(slot), fmt::format("the {} of '{}' must not be zero",
                                                slots_[slot].name, call_.function));
        return std::nullopt;
    }
    return parts;
}

std::optional<field::Colour> CombinationArguments::colour(std::size_t slot) const {
    const Value value = lower_expression(lowering_, *bound_[slot]);
    if (is_nothing(value) || report_function(lowering_, span(slot), value)) return std::nullopt;
    if (const auto* phase = std::get_if<NodeId>(&value)) {
        return field::palette(lowering_.field.graph, *phase);
    }
    const auto* vector = std::get_if<VectorValue>(&value);
    if (vector && vector->components.size() == 3) {
        return field::Colour{vector->components[0], vector->components[1], vector->components[2]};
    }
    lowering_.error(span(slot), fmt::format("a colour is a number or (red, green, blue), not {}",
                                            describe(value)));
    return std::nullopt;
}

std::optional<Vector> CombinationArguments::map(std::size_t slot) const {
    const auto function = as_function(lowering_, *bound_[slot], "a map of space");
    if (!function) return std::nullopt;
    const field::Point here = field::coordinates(lowering_.field.graph);
    const VectorValue point{Algebra::vector, {here.begin(), here.end()}, {}};
    const Value there = apply(lowering_, *function, span(slot), std::array<Value, 1>{point});
    if (is_nothing(there)) return std::nullopt;
    const auto* vector = std::get_if<VectorValue>(&there);
    if (!vector || vector->components.size() != 3) {
        lowering_.error(span(slot), fmt::format("a map of space must give a vector of 3, not {}",
                                                describe(there)));
        return std::nullopt;
    }
    return Vector{vector->components[0], vector->components[1], vector->components[2]};
}

std::optional<Vector> CombinationArguments::vector(std::size_t slot) const {
    const auto parts = components(slot, 3);
    if (!parts) return std::nullopt;
    return Vector{(*parts)[0], (*parts)[1], (*parts)[2]};
}

}  // namespace formula
