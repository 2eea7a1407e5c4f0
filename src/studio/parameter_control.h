// SPDX-License-Identifier: MIT
// The control of one parameter of the formula, as its type wants it.
#pragma once

#include <vector>

#include "field/parameter.h"

namespace studio {

/// A slider, a row of them, a colour, a list of labels, or a box to tick; angles are shown in
/// degrees. Answers whether the components have changed.
bool parameter_control(const field::Parameter& parameter, std::vector<double>& components);

}  // namespace studio
