// SPDX-License-Identifier: MIT
// What a node of the tree holds: its expressions, and the nodes below it.
#pragma once

#include <vector>

#include "field/field.h"

namespace field {

/// The places of all expressions of the node itself, always in the same order.
std::vector<graph::NodeId*> expressions(Node& node);
/// All expressions of the node itself, in the same order.
std::vector<graph::NodeId> expressions(const Node& node);

/// The node as far as its values go: without colours and the state that only they need, without
/// what only a Lipschitz constant is found from, and without what says the same in another way.
Node shape(const Field& field, FieldId id);

/// The nodes right below, from left to right; none below a leaf.
std::vector<FieldId> children(const Node& node);

}  // namespace field
