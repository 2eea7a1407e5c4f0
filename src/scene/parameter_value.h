// SPDX-License-Identifier: MIT
// A value of a formula's parameter as people write it: what it means is said by the formula.
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "base/source_span.h"

namespace scene {

/// A number; a vector's two to four components; a choice's label; on or off.
using ParameterValue = std::variant<double, std::vector<double>, std::string, bool>;

/// Values by the parameter's name.
using ParameterValues = std::map<std::string, ParameterValue>;

/// Where a value stands in a preset's text, by the parameter's name.
struct ParameterPlace {
    base::SourceSpan name, value;
};
using ParameterPlaces = std::map<std::string, ParameterPlace>;

}  // namespace scene
