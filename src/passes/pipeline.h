// SPDX-License-Identifier: MIT
// The order of the passes.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "passes/rewrite.h"

namespace passes {

struct Pass {
    std::string_view name;
    Transformation transformation;
};

/// All passes in the order in which they run.
std::span<const Pass> pipeline();

/// Runs all passes over every expression of a field, in place. Deterministic. A pass after which
/// there would be more to compute at each point (OperationCount::multiplied_out) is left out. After
/// each pass `observer` gets it and the field.
using Observer = std::function<void(const Pass&, const field::Field&)>;
void run(field::Field& field, const Observer& observer = {});
/// The same for some expressions of a graph.
std::vector<graph::NodeId> run(graph::Graph& graph, std::span<const graph::NodeId> roots);

}  // namespace passes
