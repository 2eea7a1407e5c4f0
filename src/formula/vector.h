// SPDX-License-Identifier: MIT
// Vectors of two to four graph nodes, component by component. Internal to the library.
#pragma once

#include <vector>

#include "graph/build.h"

namespace formula {

using Components = std::vector<graph::Expr>;

Components components(graph::Graph& graph, const std::vector<graph::NodeId>& nodes);
std::vector<graph::NodeId> nodes(const Components& components);

// Of two with the same number of components.
Components operator+(const Components& a, const Components& b);
Components operator-(const Components& a, const Components& b);
graph::Expr dot(const Components& a, const Components& b);

Components operator-(const Components& a);
Components operator*(graph::Expr factor, const Components& a);
Components operator*(const Components& a, graph::Expr factor);
Components operator/(const Components& a, graph::Expr divisor);

/// Of three components each.
Components cross(const Components& a, const Components& b);

graph::Expr length(const Components& a);

}  // namespace formula
