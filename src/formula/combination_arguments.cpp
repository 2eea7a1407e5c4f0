// SPDX-License-Identifier: MIT
#include "formula/combination_arguments.h"

#include <fmt/format.h>

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
                                                                    std::size_t count) const {
    auto parts = uniform_components(lowering_, call_, slots_[slot].name, *bound_[slot], count);
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
    if (!number) return std::nullopt;
    const graph::Graph& graph = lowering_.field.graph;
    if (graph.is_constant(*number) && !(graph[*number].value > 0)) {
        error(slot, "must be above 0");
        return std::nullopt;
    }
    return number;
}

std::optional<Vector> CombinationArguments::vector(std::size_t slot) const {
    const auto parts = components(slot, 3);
    if (!parts) return std::nullopt;
    return Vector{(*parts)[0], (*parts)[1], (*parts)[2]};
}

}  // namespace formula
