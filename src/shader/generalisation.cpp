// SPDX-License-Identifier: MIT
#include "shader/generalisation.h"

#include <array>
#include <map>

namespace shader {
namespace {

using graph::NodeId;

/// Larger expressions are nothing that there are many of.
constexpr std::size_t most_nodes = 200;

// What stands in a pattern: these, else an operator.
constexpr std::uint32_t number_place = 1000, moved_coordinate = 1001, seen_before = 1002;

/// A coordinate that nothing is subtracted from.
bool is_bare(const graph::Node& node) { return node.op == graph::Op::variable; }
/// A coordinate less a number.
bool is_moved(const graph::Graph& graph, const std::vector<bool>& depends,
              const graph::Node& node) {
    return node.op == graph::Op::sub && is_bare(graph[node.arguments[0]]) &&
           !depends[index(node.arguments[1])];
}

struct Walk {
    const graph::Graph& graph;
    const std::vector<bool>& depends;
    NodeId zero;
    Generalisation found{};
    std::map<NodeId, std::uint32_t> places{};

    void visit(NodeId id) {
        if (!depends[index(id)]) return add_number(id);
        const auto next = static_cast<std::uint32_t>(places.size());
        const auto [place, is_new] = places.try_emplace(id, next);
        if (!is_new) {
            found.pattern.insert(found.pattern.end(), {seen_before, place->second});
            return;
        }
        if (places.size() > most_nodes) return;
        const graph::Node& node = graph[id];
        if (is_bare(node)) return add_moved(node.symbol, zero);
        if (is_moved(graph, depends, node)) {
            return add_moved(graph[node.arguments[0]].symbol, node.arguments[1]);
        }
        found.pattern.push_back(static_cast<std::uint32_t>(node.op));
        for (const NodeId argument : node.args()) visit(argument);
    }
    void add_number(NodeId id) {
        found.pattern.push_back(number_place);
        found.numbers.push_back(id);
    }
    void add_moved(std::uint32_t coordinate, NodeId by) {
        found.pattern.insert(found.pattern.end(), {moved_coordinate, coordinate});
        found.numbers.push_back(by);
    }
};

struct Clone {
    graph::Graph& graph;
    const std::vector<bool>& depends;
    std::span<const NodeId> numbers;
    std::size_t next = 0;
    std::map<NodeId, NodeId> copies{};

    NodeId visit(NodeId id) {
        if (!depends[index(id)]) return numbers[next++];
        const auto known = copies.find(id);
        if (known != copies.end()) return known->second;
        const NodeId copy = copy_of(id);
        copies.emplace(id, copy);
        return copy;
    }
    NodeId copy_of(NodeId id) {
        const graph::Node node = graph[id];  // a copy: adding nodes moves them
        if (is_bare(node)) return moved(id);
        if (is_moved(graph, depends, node)) return moved(node.arguments[0]);
        std::array<NodeId, graph::max_arity> arguments{};
        for (std::size_t i = 0; i < node.args().size(); ++i) {
            arguments[i] = visit(node.arguments[i]);
        }
        return graph.apply(node.op, std::span(arguments).first(node.args().size()));
    }
    NodeId moved(NodeId coordinate) {
        const NodeId by = numbers[next++];
        if (graph.is_constant(by, 0)) return coordinate;
        return graph.apply(graph::Op::sub, coordinate, by);
    }
};

}  // namespace

Generalisation generalise(graph::Graph& graph, const std::vector<bool>& depends,
                          std::span<const NodeId> roots) {
    const NodeId zero = graph.constant(0);
    Walk walk{graph, depends, zero};
    for (const NodeId root : roots) walk.visit(root);
    if (walk.places.size() > most_nodes) return {};
    return std::move(walk.found);
}

std::vector<NodeId> with_numbers(graph::Graph& graph, const std::vector<bool>& depends,
                                 std::span<const NodeId> roots, std::span<const NodeId> numbers) {
    Clone clone{graph, depends, numbers};
    std::vector<NodeId> copies;
    for (const NodeId root : roots) copies.push_back(clone.visit(root));
    return copies;
}

}  // namespace shader
