// SPDX-License-Identifier: MIT
// Expressions as whole powers of others.
#pragma once

#include <vector>

#include "graph/graph.h"

namespace passes {

/// base^exponent, with 1 for what is no power.
struct PowerOf {
    graph::NodeId base{};
    int exponent = 1;
};

/// Tells of each node of a graph what power it is: of pow with a whole constant exponent, and of
/// products of powers of one base, as long as the exponent is at most largest_chained_exponent. The
/// graph may grow meanwhile, but must not go before.
class Powers {
public:
    explicit Powers(const graph::Graph& graph) : graph_(graph) {}
    PowerOf operator[](graph::NodeId id);

private:
    PowerOf of(const graph::Node& node, graph::NodeId id) const;

    const graph::Graph& graph_;
    std::vector<PowerOf> known_;
};

/// The whole number from 1 to largest_chained_exponent that a constant is, or 0.
int whole_exponent(const graph::Graph& graph, graph::NodeId id);

}  // namespace passes
