// SPDX-License-Identifier: MIT
// The order of the passes.
#pragma once

#include <span>
#include <string_view>

#include "passes/rewrite.h"

namespace passes {

struct Pass {
    std::string_view name;
    Rule rule;
};

/// All passes in the order in which they run.
std::span<const Pass> pipeline();

/// Runs all passes over every expression of a field, in place. Deterministic.
void run(field::Field& field);
/// The same for some expressions of a graph.
std::vector<graph::NodeId> run(graph::Graph& graph, std::span<const graph::NodeId> roots);

}  // namespace passes
