// SPDX-License-Identifier: MIT
// The order of the passes.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "passes/rewrite.h"

namespace passes {

/// What the outcome of a pass is for.
enum class Stage {
    meaning,     ///< what all others read: derivatives and bounds are those of this form
    evaluation,  ///< cheaper to compute at points, but a worse start for derivatives and bounds
};

struct Pass {
    std::string_view name;
    Transformation transformation;
    Stage stage = Stage::meaning;
};

/// All passes in the order in which they run: first those of the meaning, then the others.
std::span<const Pass> pipeline();

/// Runs the passes of one stage over every expression of a field, in place. Deterministic. A pass
/// after which there would be more to compute at each point (OperationCount::multiplied_out) is
/// left out. After each pass `observer` gets it and the field.
using Observer = std::function<void(const Pass&, const field::Field&)>;
void run(field::Field& field, Stage stage = Stage::meaning, const Observer& observer = {});
/// The same for some expressions of a graph.
std::vector<graph::NodeId> run(graph::Graph& graph, std::span<const graph::NodeId> roots,
                               Stage stage = Stage::meaning);

}  // namespace passes
