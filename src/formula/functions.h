// SPDX-License-Identifier: MIT
// The functions of numbers: one table with names, arguments and how each becomes nodes.
#pragma once

#include <span>
#include <string_view>

#include "graph/graph.h"

namespace formula {

/// What a function of numbers means for vectors: it is applied to each component of those that it
/// takes, where numbers among the arguments count for every component.
enum class OnVectors {
    none,   ///< it takes numbers only
    plain,  ///< plain vectors; of complex numbers it would be something else
    all,    ///< complex numbers, quaternions and triplex numbers too
};

struct Function {
    std::string_view name;
    std::string_view signature;  ///< how a call is written
    std::size_t least;           ///< number of arguments
    std::size_t most;
    OnVectors on_vectors;
    graph::NodeId (*build)(graph::Graph&, std::span<const graph::NodeId>);
};

inline constexpr std::size_t any_number = static_cast<std::size_t>(-1);

/// All of them, sorted by name. Those without an operator of their own are composed; `r` is a name,
/// not a function.
std::span<const Function> functions();
const Function* find_function(std::string_view name);

/// The distance of the point from the origin, the name `r`.
graph::NodeId radius(graph::Graph& graph);

}  // namespace formula
