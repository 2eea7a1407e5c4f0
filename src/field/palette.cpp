// SPDX-License-Identifier: MIT
#include "field/palette.h"

#include <numbers>
#include <utility>

#include "field/overloaded.h"
#include "graph/build.h"

namespace field {
namespace {

/// middle + swing cos(tau (phase - crest)): the channel is largest at its crest.
struct Channel {
    double middle, swing, crest;
};
constexpr std::array<Channel, 3> channels{
    {{0.46, 0.40, 0.08}, {0.37, 0.26, 0.20}, {0.33, 0.29, 0.48}}};

}  // namespace

Colour palette(graph::Graph& graph, graph::NodeId phase) {
    const graph::Expr angle = graph::Expr(graph, phase) * (2 * std::numbers::pi);
    Colour colour{};
    for (std::size_t i = 0; i < colour.size(); ++i) {
        const Channel& it = channels[i];
        colour[i] = (it.middle + it.swing * cos(angle - 2 * std::numbers::pi * it.crest)).id;
    }
    return colour;
}

FieldId coloured(Field& field, FieldId id, const Colour& colour) {
    Node node = field[id];  // a copy: adding nodes moves them
    const auto below = [&](FieldId& child) { child = coloured(field, child, colour); };
    std::visit(Overloaded{[&](Formula& leaf) { leaf.colour = colour; },
                          [&](Iteration& leaf) { leaf.colour = colour; },
                          [&](Complement& n) { below(n.a); },
                          [&](Blend& n) {
                              for (FieldId& operand : n.operands) below(operand);
                          },
                          // The point outside of the cells is not known below.
                          [&](Cells& n) { n.colour = colour; },
                          [&](auto& n) {
                              below(n.a);
                              below(n.b);
                          }},
               node);
    return field.add(std::move(node));
}

}  // namespace field
