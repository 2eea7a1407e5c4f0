// SPDX-License-Identifier: MIT
#include "graph/graph.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace graph {
namespace {

std::size_t mix(std::size_t seed, std::uint64_t value) {
    // The finaliser of splitmix64 over the running state.
    std::uint64_t z = (seed ^ value) + 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return static_cast<std::size_t>(z ^ (z >> 31));
}

std::size_t hash(const Node& node) {
    // Unused arguments are always 0.
    const auto pair = [&](std::size_t i) {
        return std::uint64_t{index(node.arguments[i])} << 32 | index(node.arguments[i + 1]);
    };
    const auto kind = static_cast<std::uint64_t>(node.op) << 32 | node.symbol;
    const std::size_t seed = mix(mix(0, kind), std::bit_cast<std::uint64_t>(node.value) ^ pair(0));
    return arity(node.op) > 2 ? mix(seed, pair(2)) : seed;
}

bool same(const Node& a, const Node& b) {
    // By bits, so that 0 and -0 stay apart and NaN equals itself.
    return a.op == b.op && a.symbol == b.symbol && a.arguments == b.arguments &&
           std::bit_cast<std::uint64_t>(a.value) == std::bit_cast<std::uint64_t>(b.value);
}

}  // namespace

Graph::Graph() {
    for (const char* name : {"x", "y", "z"}) new_variable(name);
    new_parameter("t");
}

void Graph::grow_places() {
    places_.assign(std::max<std::size_t>(64, 2 * places_.size()), 0);
    const std::size_t mask = places_.size() - 1;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        std::size_t place = hash(nodes_[i]) & mask;
        while (places_[place] != 0) place = (place + 1) & mask;
        places_[place] = static_cast<std::uint32_t>(i + 1);
    }
}

NodeId Graph::intern(const Node& node) {
    if (2 * (nodes_.size() + 1) > places_.size()) grow_places();
    const std::size_t mask = places_.size() - 1;
    std::size_t place = hash(node) & mask;
    for (; places_[place] != 0; place = (place + 1) & mask) {
        const std::uint32_t known = places_[place] - 1;
        if (same(nodes_[known], node)) return static_cast<NodeId>(known);
    }
    nodes_.push_back(node);
    places_[place] = static_cast<std::uint32_t>(nodes_.size());
    return static_cast<NodeId>(nodes_.size() - 1);
}

NodeId Graph::constant(double value) { return intern({.op = Op::constant, .value = value}); }

NodeId Graph::variable(VariableId id) {
    assert(index(id) < variable_names_.size());
    return intern({.op = Op::variable, .symbol = static_cast<std::uint32_t>(id)});
}

NodeId Graph::parameter(ParameterId id) {
    assert(index(id) < parameter_names_.size());
    return intern({.op = Op::parameter, .symbol = static_cast<std::uint32_t>(id)});
}

NodeId Graph::apply(Op op, std::span<const NodeId> arguments) {
    assert(arguments.size() == arity(op) && !arguments.empty());
    Node node{.op = op};
    std::ranges::copy(arguments, node.arguments.begin());
    return intern(node);
}

VariableId Graph::new_variable(std::string name) {
    variable_names_.push_back(std::move(name));
    return static_cast<VariableId>(variable_names_.size() - 1);
}

ParameterId Graph::new_parameter(std::string name) {
    parameter_names_.push_back(std::move(name));
    return static_cast<ParameterId>(parameter_names_.size() - 1);
}

bool Graph::is_constant(NodeId id, double value) const {
    const Node& node = nodes_[index(id)];
    return node.op == Op::constant && node.value == value;
}

std::vector<NodeId> reachable(const Graph& graph, std::span<const NodeId> roots) {
    if (roots.empty()) return {};
    // One bit a node in words of 64, so that what is not needed costs next to nothing: the largest
    // number first, and arguments always have smaller ones.
    std::vector<std::uint64_t> needed(index(std::ranges::max(roots)) / 64 + 1, 0);
    const auto mark = [&](NodeId id) {
        needed[index(id) / 64] |= std::uint64_t{1} << (index(id) % 64);
    };
    std::ranges::for_each(roots, mark);
    std::vector<NodeId> order;
    for (std::size_t word = needed.size(); word-- > 0;) {
        std::uint64_t below = ~std::uint64_t{0};
        while (const std::uint64_t left = needed[word] & below) {
            const int bit = std::bit_width(left) - 1;
            below = (std::uint64_t{1} << bit) - 1;
            const auto id = static_cast<NodeId>(word * 64 + static_cast<std::size_t>(bit));
            order.push_back(id);
            std::ranges::for_each(graph[id].args(), mark);
        }
    }
    std::ranges::reverse(order);
    return order;
}

std::vector<bool> depends_on_variables(const Graph& graph) {
    std::vector<bool> depends(graph.size(), false);
    for (std::size_t i = 0; i < graph.size(); ++i) {
        const Node& node = graph[static_cast<NodeId>(i)];
        depends[i] = node.op == Op::variable ||
                     std::ranges::any_of(node.args(), [&](NodeId a) { return depends[index(a)]; });
    }
    return depends;
}

}  // namespace graph
