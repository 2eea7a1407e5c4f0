// SPDX-License-Identifier: MIT
// From a number to a colour.
#pragma once

#include "field/field.h"

namespace field {

/// The built-in palette: a closed way through colours of middle brightness, once around as the
/// number grows by 1; smooth, linear RGB. A cosine for each channel, shifted against each other
/// (after I. Quilez, "Palettes", 1999: the form, not the constants).
Colour palette(graph::Graph& graph, graph::NodeId phase);

/// The same shape with this own colour (of the point) for all its leaves.
FieldId coloured(Field& field, FieldId id, const Colour& colour);

}  // namespace field
