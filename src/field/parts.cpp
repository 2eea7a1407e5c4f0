// SPDX-License-Identifier: MIT
#include "field/parts.h"

#include <span>

namespace field {
namespace {

using graph::NodeId;

struct Expressions {
    std::vector<NodeId*> list{};

    void add(NodeId& id) { list.push_back(&id); }
    void add(std::optional<NodeId>& id) {
        if (id) list.push_back(&*id);
    }
    void add(std::optional<std::array<NodeId, 3>>& ids) {
        if (ids) add_all(*ids);
    }
    void add(Image& image) {
        add_all(image.point);
        add(image.turn);
    }
    template <class Range>
    void add_all(Range& range) {
        for (NodeId& id : range) list.push_back(&id);
    }

    void operator()(Formula& leaf) {
        add(leaf.value);
        for (Distortion& distortion : leaf.distortions) {
            add(distortion.image);
            add(distortion.displacement);
        }
        add(leaf.colour);
        for (Minimum& minimum : leaf.minima) {
            add_all(minimum.operands);
            add(minimum.width);
        }
        if (!leaf.minima.empty()) add(leaf.outline);
    }
    void operator()(Iteration& leaf) {
        add_all(leaf.start);
        add_all(leaf.step);
        add(leaf.limit);
        add(leaf.escape);
        add(leaf.distance);
        add(leaf.evenness);
        if (leaf.image) add(*leaf.image);
        add(leaf.colour);
    }
    void operator()(Union&) {}
    void operator()(Intersection&) {}
    void operator()(Complement&) {}
    void operator()(Blend& node) {
        add(node.value);
        add(node.displacement);
    }
    void operator()(Choice& node) {
        add(node.less);
        add(node.than);
    }
    void operator()(Cells& node) {
        add_all(node.point);
        add_all(node.walls);
        add_all(node.index);
        add(node.colour);
    }
};

struct Children {
    using List = std::vector<FieldId>;
    List operator()(const Formula&) const { return {}; }
    List operator()(const Iteration&) const { return {}; }
    List operator()(const Complement& node) const { return {node.a}; }
    List operator()(const Union& node) const { return {node.a, node.b}; }
    List operator()(const Intersection& node) const { return {node.a, node.b}; }
    List operator()(const Blend& node) const { return node.operands; }
    List operator()(const Choice& node) const { return {node.a, node.b}; }
    List operator()(const Cells& node) const { return {node.a}; }
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
    if (auto* formula = std::get_if<Formula>(&node)) {
        formula->colour.reset();
        formula->distortions.clear();
        formula->minima.clear();
    }
    if (auto* cells = std::get_if<Cells>(&node)) cells->colour.reset();
    auto* iteration = std::get_if<Iteration>(&node);
    if (!iteration) return node;
    const std::vector<bool> needed =
        needed_state(field.graph, *iteration, std::span(&iteration->distance, 1));
    Iteration result = *iteration;
    result.colour.reset();
    result.image.reset();
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
