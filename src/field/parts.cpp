// SPDX-License-Identifier: MIT
#include "field/parts.h"

#include <span>

namespace field {
namespace {

using graph::NodeId;

struct Expressions {
    std::vector<NodeId*> list{};

    void add(std::optional<Colour>& colour) {
        if (!colour) return;
        for (NodeId& id : *colour) list.push_back(&id);
    }
    void operator()(Formula& leaf) {
        list.push_back(&leaf.value);
        add(leaf.colour);
    }
    void operator()(Iteration& leaf) {
        for (NodeId& id : leaf.start) list.push_back(&id);
        for (NodeId& id : leaf.step) list.push_back(&id);
        list.push_back(&leaf.limit);
        if (leaf.escape) list.push_back(&*leaf.escape);
        list.push_back(&leaf.distance);
        add(leaf.colour);
    }
    void operator()(SmoothUnion& node) { list.push_back(&node.k); }
    void operator()(Union&) {}
    void operator()(Intersection&) {}
    void operator()(Complement&) {}
};

struct Children {
    std::vector<FieldId> operator()(const Formula&) const { return {}; }
    std::vector<FieldId> operator()(const Iteration&) const { return {}; }
    std::vector<FieldId> operator()(const Complement& node) const { return {node.a}; }
    std::vector<FieldId> operator()(const Union& node) const { return {node.a, node.b}; }
    std::vector<FieldId> operator()(const Intersection& node) const { return {node.a, node.b}; }
    std::vector<FieldId> operator()(const SmoothUnion& node) const { return {node.a, node.b}; }
};

}  // namespace

std::vector<NodeId*> expressions(Node& node) {
    Expressions found;
    std::visit(found, node);
    return std::move(found.list);
}

std::vector<NodeId> expressions(const Node& node) {
    Node copy = node;
    std::vector<NodeId> list;
    for (const NodeId* place : expressions(copy)) list.push_back(*place);
    return list;
}

Node shape(const Field& field, FieldId id) {
    Node node = field[id];
    if (auto* formula = std::get_if<Formula>(&node)) formula->colour.reset();
    auto* iteration = std::get_if<Iteration>(&node);
    if (!iteration) return node;
    const std::vector<bool> needed =
        needed_state(field.graph, *iteration, std::span(&iteration->distance, 1));
    Iteration result = *iteration;
    result.colour.reset();
    result.state.clear();
    result.start.clear();
    result.step.clear();
    for (std::size_t i = 0; i < needed.size(); ++i) {
        if (!needed[i]) continue;
        result.state.push_back(iteration->state[i]);
        result.start.push_back(iteration->start[i]);
        result.step.push_back(iteration->step[i]);
    }
    return result;
}

std::vector<FieldId> children(const Node& node) { return std::visit(Children{}, node); }

}  // namespace field
