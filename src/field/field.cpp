// SPDX-License-Identifier: MIT
#include "field/field.h"

#include <algorithm>
#include <utility>

#include "field/parts.h"

namespace field {
namespace {

void collect_leaves(const Field& field, FieldId id, std::vector<FieldId>& list) {
    const std::vector<FieldId> below = children(field[id]);
    if (below.empty()) list.push_back(id);
    for (const FieldId child : below) collect_leaves(field, child, list);
}

}  // namespace

Point coordinates(graph::Graph& graph) {
    return {graph.variable(graph::variable_x), graph.variable(graph::variable_y),
            graph.variable(graph::variable_z)};
}

Kind kind_of(const Field& field, FieldId id) {
    const Node& node = field[id];
    if (const auto* leaf = std::get_if<Formula>(&node)) return leaf->kind;
    if (std::holds_alternative<Complement>(node) || std::holds_alternative<Blend>(node)) {
        return Kind::solid;
    }
    const auto is_sheet = [&](FieldId child) { return kind_of(field, child) == Kind::sheet; };
    return std::ranges::any_of(children(node), is_sheet) ? Kind::sheet : Kind::solid;
}

std::vector<bool> needed_state(const graph::Graph& graph, const Iteration& iteration,
                               std::span<const graph::NodeId> answers) {
    std::vector<bool> needed(iteration.state.size(), false);
    std::vector<graph::NodeId> roots(answers.begin(), answers.end());
    if (iteration.escape) roots.push_back(*iteration.escape);
    // What a needed variable's step needs is needed too.
    while (!roots.empty()) {
        std::vector<graph::NodeId> steps;
        for (const graph::NodeId id : reachable(graph, roots)) {
            const graph::Node& node = graph[id];
            if (node.op != graph::Op::variable) continue;
            const auto variable = static_cast<graph::VariableId>(node.symbol);
            const auto found = std::ranges::find(iteration.state, variable);
            if (found == iteration.state.end()) continue;
            const auto i = static_cast<std::size_t>(found - iteration.state.begin());
            if (!needed[i]) steps.push_back(iteration.step[i]);
            needed[i] = true;
        }
        roots = std::move(steps);
    }
    return needed;
}

std::optional<Colour> colour_of(const Node& leaf) {
    if (const auto* formula = std::get_if<Formula>(&leaf)) return formula->colour;
    if (const auto* iteration = std::get_if<Iteration>(&leaf)) return iteration->colour;
    return std::nullopt;
}

std::vector<FieldId> leaves(const Field& field, FieldId id) {
    std::vector<FieldId> list;
    collect_leaves(field, id, list);
    return list;
}

}  // namespace field
