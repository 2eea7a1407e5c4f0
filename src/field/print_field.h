// SPDX-License-Identifier: MIT
// Fields as text for people.
#pragma once

#include <string>

#include "field/field.h"

namespace field {

/// The tree, indented, each leaf with its expressions in the form of graph::print. Depends on the
/// shape alone: the same formula gives the same text.
std::string print(const Field& field);

}  // namespace field
