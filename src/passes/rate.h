// SPDX-License-Identifier: MIT
// How often a value changes, and so how often it must be computed.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/graph.h"

namespace passes {

/// From slow to fast; a node is as fast as its fastest argument.
enum class Rate : std::uint8_t {
    never,  ///< constants alone: computed by the passes
    frame,  ///< parameters: computed by the CPU, handed over as a number
    point,  ///< x, y, z: computed at each point
    turn,   ///< the state of an iteration: computed at each turn of its loop
};

/// The rates of a graph's nodes. The graph may grow meanwhile, but must not go before.
class Rates {
public:
    explicit Rates(const graph::Graph& graph) : graph_(graph) {}
    Rate operator[](graph::NodeId id);

private:
    const graph::Graph& graph_;
    std::vector<Rate> known_;
};

}  // namespace passes
