// SPDX-License-Identifier: MIT
// What a formula lets its user move: sliders, colours, choices, switches.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/source_span.h"
#include "graph/graph.h"

namespace field {

/// How a parameter is shown and what it may be; `real` covers numbers and vectors.
enum class ParameterType { real, integer, logarithmic, angle, colour, choice, toggle };

/// A parameter of the formula, with one to four components. The value of a choice is the index of
/// its label, that of a toggle 1 or 0; angles are radians, colours linear RGB.
struct Parameter {
    std::string name;
    std::string label;    ///< the name if none was given
    std::string group;    ///< the heading that it is shown under; empty: under none
    std::string tooltip;  ///< empty if there is none
    ParameterType type = ParameterType::real;
    std::vector<graph::ParameterId> ids;  ///< of each component
    std::vector<double> initial;          ///< of each component
    double minimum = 0;  ///< of every component; of sliders, no limit of the formula
    double maximum = 1;
    std::optional<double> step;
    std::vector<std::string> choices;  ///< labels of a choice
    base::SourceSpan span;             ///< of the name

    std::size_t size() const { return initial.size(); }
};

/// The name of a component: of `c` it is `c.x`, of a parameter with a single one just its name.
std::string component_name(const Parameter& parameter, std::size_t component);

}  // namespace field
