// SPDX-License-Identifier: MIT
// A pure, acyclic expression over scalars, hash-consed: equal expressions are one node.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "graph/operator.h"

namespace graph {

/// A node of a Graph. Arguments always have smaller numbers than the node that uses them.
enum class NodeId : std::uint32_t {};
/// A variable: 0, 1, 2 are the point x, y, z in world coordinates; others are the state of
/// iterations, made by Graph::new_variable.
enum class VariableId : std::uint32_t {};
/// A number that is the same for every point of a frame: 0 is the time t in seconds, others are
/// made by Graph::new_parameter.
enum class ParameterId : std::uint32_t {};

constexpr std::size_t index(NodeId id) { return static_cast<std::size_t>(id); }
constexpr std::size_t index(VariableId id) { return static_cast<std::size_t>(id); }
constexpr std::size_t index(ParameterId id) { return static_cast<std::size_t>(id); }

inline constexpr VariableId variable_x{0}, variable_y{1}, variable_z{2};
inline constexpr ParameterId parameter_t{0};

struct Node {
    Op op = Op::constant;
    std::array<NodeId, max_arity> arguments{};  ///< the first arity of them count
    double value = 0;                           ///< of a constant
    std::uint32_t symbol = 0;                   ///< VariableId or ParameterId of such a leaf

    std::span<const NodeId> args() const { return {arguments.data(), arity(op)}; }
};

/// The arena of nodes. It only grows: a node never changes once made, so NodeIds stay good.
/// Copying a graph copies the arena and keeps all ids.
class Graph {
public:
    Graph();

    NodeId constant(double value);
    NodeId variable(VariableId id);
    NodeId parameter(ParameterId id);
    /// The operator on these arguments; exactly as many as its arity. No rewriting happens here.
    NodeId apply(Op op, std::span<const NodeId> arguments);
    template <class... Ids>
    NodeId apply(Op op, NodeId first, Ids... rest) {
        const std::array<NodeId, 1 + sizeof...(rest)> list{first, rest...};
        return apply(op, std::span<const NodeId>(list));
    }

    VariableId new_variable(std::string name);
    ParameterId new_parameter(std::string name);

    const Node& operator[](NodeId id) const { return nodes_[index(id)]; }
    std::size_t size() const { return nodes_.size(); }
    std::size_t variable_count() const { return variable_names_.size(); }
    std::size_t parameter_count() const { return parameter_names_.size(); }
    const std::string& name(VariableId id) const { return variable_names_[index(id)]; }
    const std::string& name(ParameterId id) const { return parameter_names_[index(id)]; }

    /// True if the node is a constant, and then of what value.
    bool is_constant(NodeId id) const { return nodes_[index(id)].op == Op::constant; }
    bool is_constant(NodeId id, double value) const;

private:
    NodeId intern(const Node& node);
    void grow_places();

    std::vector<Node> nodes_;
    /// Where equal nodes are found: a hash table of numbers of nodes plus 1, or 0 for a free place;
    /// open addressing, half empty at least, its size a power of two.
    std::vector<std::uint32_t> places_;
    std::vector<std::string> variable_names_;
    std::vector<std::string> parameter_names_;
};

/// The nodes that the roots need, each once, arguments before users, in increasing order.
std::vector<NodeId> reachable(const Graph& graph, std::span<const NodeId> roots);

/// True for each node (by index) that depends on a variable (point or state).
std::vector<bool> depends_on_variables(const Graph& graph);

}  // namespace graph
