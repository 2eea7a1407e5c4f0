// SPDX-License-Identifier: MIT
// All that is known about a scene and about each of its objects, for some parameter values.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analysis/cost.h"
#include "analysis/dependence.h"
#include "analysis/extent.h"
#include "analysis/metric.h"
#include "analysis/region.h"
#include "analysis/smoothness.h"
#include "field/field.h"

namespace analysis {

/// Of one object, or of the whole scene.
struct Facts {
    field::Kind kind = field::Kind::solid;
    /// By structure (polynomial_degree); none if it is no polynomial, or no single expression.
    std::optional<int> degree;
    /// Rigorous over the region. Joining objects makes kinks, and the answer of an escape-time
    /// iteration may jump.
    Regularity regularity;
    Metric metric = Metric::none;
    /// Rigorous: a Lipschitz constant over the region; +infinity if none was found, and for
    /// whatever is no single expression.
    double lipschitz = numeric::infinity;
    /// Rigorous: holds all of it that is in the region; none if nothing is, proven.
    std::optional<Cell> box;
    Reach reach = Reach::open;  ///< if there is a box
    bool full = false;          ///< proven: the region is inside of it
    Dependence dependence;      ///< by structure
    Cost cost;
};

struct SceneFacts {
    Facts whole;
    /// In the order of field::leaves. Of an object in cells all copies count, where they are.
    std::vector<Facts> objects;
};

/// Tens of milliseconds. `parameters` is indexed by ParameterId.
SceneFacts find_facts(const field::Field& field, const Region& region,
                      std::span<const double> parameters);

}  // namespace analysis
