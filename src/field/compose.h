// SPDX-License-Identifier: MIT
// A tree of formulas as one formula.
#pragma once

#include <optional>

#include "field/field.h"

namespace field {

/// The one expression of a tree of solid formulas, with minimum and maximum for union and
/// intersection; none if the tree holds anything else, or colours that differ. It is a distance if
/// all of them are.
std::optional<Formula> composed(Field& field, FieldId id);

/// The formulas' outlines, by their minima where there are any, with variables that tell the minima
/// of all of them apart; the minima are added to the whole. Nothing if none has minima.
std::optional<std::vector<graph::NodeId>> take_minima(Field& field,
                                                      const std::vector<Formula>& parts,
                                                      Formula& whole);

/// What is known of the distances in an expression that changes by no more than that one of the
/// given formulas which changes most: a distance or a scalar, with its distortions; none if their
/// colours differ. `value` stays to be filled in.
std::optional<Formula> joined(Field& field, const std::vector<Formula>& parts);

}  // namespace field
