// SPDX-License-Identifier: MIT
// What the value of a part of a scene says about the distance to its surface.
#pragma once

#include <functional>

#include "field/field.h"

namespace analysis {

/// In decreasing order of what is known.
enum class Metric {
    exact,     ///< the signed distance itself, by construction
    bound,     ///< never more than the distance: 1-Lipschitz, by construction or by proof
    estimate,  ///< an estimate of the distance that may be too large: heuristic
    none,      ///< the sign and the zeros only
};

/// Of a node of the tree. A set operation on distances is a bound, also where both are exact:
/// inside of a union, or outside of an intersection, the nearest surface may be one that is not
/// there. A formula is a bound where `lipschitz`, which is asked for a rigorous Lipschitz constant
/// over the region, says at most 1.
Metric metric(const field::Field& field, field::FieldId id,
              const std::function<double(field::FieldId)>& lipschitz);

}  // namespace analysis
