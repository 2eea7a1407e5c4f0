// SPDX-License-Identifier: MIT
#include "passes/derivative_along.h"

#include "passes/differentiate.h"
#include "passes/pipeline.h"

namespace passes {

graph::NodeId derivative_along(graph::Graph& graph, graph::NodeId f,
                               const std::array<graph::NodeId, 3>& direction) {
    const std::array seeds{Seed{graph::variable_x, direction[0]},
                           Seed{graph::variable_y, direction[1]},
                           Seed{graph::variable_z, direction[2]}};
    return run(graph, differentiate(graph, std::array{f}, seeds))[0];
}

}  // namespace passes
