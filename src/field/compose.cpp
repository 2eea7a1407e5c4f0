// SPDX-License-Identifier: MIT
#include "field/compose.h"

#include <algorithm>

#include "field/overloaded.h"
#include "field/parts.h"

namespace field {
namespace {

bool same(const Distortion& a, const Distortion& b) {
    return a.image.point == b.image.point && a.image.turn == b.image.turn &&
           a.displacement == b.displacement;
}

}  // namespace

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
        if (result) result->value = apply(a->value, b->value);
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
            [&](const Union& n) { return binary(n.a, n.b, by(graph::Op::min)); },
            [&](const Intersection& n) { return binary(n.a, n.b, by(graph::Op::max)); },
            [&](const Complement& n) {
                auto a = composed(field, n.a);
                if (a) a->value = field.graph.apply(graph::Op::neg, a->value);
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
