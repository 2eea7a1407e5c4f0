// SPDX-License-Identifier: MIT
// Iterations of q -> q^2 + c in the quaternions or the complex numbers.
#pragma once

#include <optional>
#include <vector>

#include "field/field.h"

namespace oracle {

/// What of an escape-time iteration decides about inside and outside, if that is q -> q^2 + c until
/// |q|^2 is above a bound. Components are listed with the real part first, two or four of them; all
/// expressions are those of the point.
struct Quadratic {
    std::vector<graph::NodeId> start;
    std::vector<graph::NodeId> constant;
    graph::NodeId minus_bound{};
};

/// Recognised by the derivatives of the step, however it is written: exact over the real numbers.
/// Nothing if it is no such iteration, or not found to be one.
std::optional<Quadratic> quadratic(graph::Graph& graph, const field::Iteration& iteration);

}  // namespace oracle
