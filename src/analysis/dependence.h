// SPDX-License-Identifier: MIT
// What an expression, or a part of a scene, depends on.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "field/field.h"
#include "graph/graph.h"

namespace analysis {

/// By structure: what is not here cannot matter; what is here need not.
struct Dependence {
    std::array<bool, 3> point{};                   ///< on x, y, z
    bool time = false;                             ///< on t
    std::vector<graph::ParameterId> parameters{};  ///< without the time, in increasing order

    bool on_point() const { return point[0] || point[1] || point[2]; }
    bool on_parameters() const { return time || !parameters.empty(); }
    friend bool operator==(const Dependence&, const Dependence&) = default;
};

Dependence dependence(const graph::Graph& graph, std::span<const graph::NodeId> roots);

/// Of the shape of a node of the tree with all below it; colours do not count.
Dependence dependence(const field::Field& field, field::FieldId id);

}  // namespace analysis
