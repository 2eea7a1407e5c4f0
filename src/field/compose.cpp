// SPDX-License-Identifier: MIT
#include "field/compose.h"

#include <algorithm>
#include <array>
#include <utility>

#include "field/overloaded.h"
#include "field/parts.h"
#include "graph/substitute.h"

namespace field {
namespace {

bool same(const Distortion& a, const Distortion& b) {
    return a.image.point == b.image.point && a.image.turn == b.image.turn &&
           a.displacement == b.displacement;
}

void collect_operands(const Field& field, FieldId id, std::vector<FieldId>& list) {
    const auto* node = std::get_if<Union>(&field[id]);
    if (!node) return list.push_back(id);
    const auto [a, b] = *node;
    collect_operands(field, a, list);
    collect_operands(field, b, list);
}

/// If a union is one of many distances, says so in its formula.
void tell_operands(Field& field, FieldId id, Formula& whole) {
    if (whole.metric != Metric::distance) return;
    std::vector<FieldId> list;
    collect_operands(field, id, list);
    if (list.size() < many) return;
    Minimum minimum{{}, {}, field.graph.new_variable("minimum")};
    for (const FieldId it : list) {
        const auto operand = composed(field, it);
        if (!operand->minima.empty()) return;
        minimum.operands.push_back(operand->value);
    }
    whole.outline = field.graph.variable(minimum.variable);
    whole.minima = {std::move(minimum)};
}

}  // namespace

std::optional<std::vector<graph::NodeId>> take_minima(Field& field,
                                                      const std::vector<Formula>& parts,
                                                      Formula& whole) {
    std::vector<graph::NodeId> outlines;
    for (const Formula& part : parts) {
        outlines.push_back(part.minima.empty() ? part.value : part.outline);
        std::vector<std::pair<graph::VariableId, graph::NodeId>> replacements;
        for (const Minimum& minimum : part.minima) {
            whole.minima.push_back(minimum);
            whole.minima.back().variable = field.graph.new_variable("minimum");
            replacements.emplace_back(minimum.variable,
                                      field.graph.variable(whole.minima.back().variable));
        }
        outlines.back() =
            graph::substitute(field.graph, std::array{outlines.back()}, replacements)[0];
    }
    if (whole.minima.empty()) return std::nullopt;
    return outlines;
}

std::optional<Formula> joined(Field& field, const std::vector<Formula>& parts) {
    Formula result{.colour = parts[0].colour};
    for (const Formula& part : parts) {
        if (part.colour != result.colour) return std::nullopt;
    }
    const auto is_distance = [](const Formula& it) { return it.metric == Metric::distance; };
    const auto is_made_of_distances = [&](const Formula& it) {
        return is_distance(it) || !it.distortions.empty();
    };
    if (std::ranges::all_of(parts, is_distance)) result.metric = Metric::distance;
    if (result.metric == Metric::distance || !std::ranges::all_of(parts, is_made_of_distances)) {
        return result;
    }
    for (const Formula& part : parts) {
        std::vector<Distortion> distortions = part.distortions;
        if (is_distance(part)) distortions = {Distortion{{coordinates(field.graph)}, {}}};
        for (const Distortion& it : distortions) {
            const auto known = [&](const Distortion& other) { return same(it, other); };
            if (std::ranges::none_of(result.distortions, known)) result.distortions.push_back(it);
        }
    }
    return result;
}

std::optional<Formula> composed(Field& field, FieldId id) {
    const auto binary = [&](FieldId a_id, FieldId b_id, auto apply) -> std::optional<Formula> {
        const auto a = composed(field, a_id);
        const auto b = a ? composed(field, b_id) : std::nullopt;
        if (!b) return std::nullopt;
        std::optional<Formula> result = joined(field, {*a, *b});
        if (!result) return std::nullopt;
        result->value = apply(a->value, b->value);
        if (const auto outlines = take_minima(field, {*a, *b}, *result)) {
            result->outline = apply((*outlines)[0], (*outlines)[1]);
        }
        return result;
    };
    const auto by = [&](graph::Op op) {
        return
            [&field, op](graph::NodeId a, graph::NodeId b) { return field.graph.apply(op, a, b); };
    };
    const Node node = field[id];  // a copy: adding nodes moves them
    return std::visit(
        Overloaded{
            [](const Formula& leaf) -> std::optional<Formula> {
                return leaf.kind == Kind::solid ? std::optional(leaf) : std::nullopt;
            },
            [&](const Union& n) {
                auto result = binary(n.a, n.b, by(graph::Op::min));
                if (result) tell_operands(field, id, *result);
                return result;
            },
            [&](const Intersection& n) { return binary(n.a, n.b, by(graph::Op::max)); },
            [&](const Complement& n) {
                auto a = composed(field, n.a);
                if (a) a->value = field.graph.apply(graph::Op::neg, a->value);
                if (a && !a->minima.empty()) {
                    a->outline = field.graph.apply(graph::Op::neg, a->outline);
                }
                return a;
            },
            [&](const Choice& n) {
                return binary(n.a, n.b, [&](graph::NodeId a, graph::NodeId b) {
                    return field.graph.apply(graph::Op::select_less, n.less, n.than, a, b);
                });
            },
            [](const auto&) -> std::optional<Formula> { return std::nullopt; },
        },
        node);
}

}  // namespace field
