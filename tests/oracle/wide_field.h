// SPDX-License-Identifier: MIT
// What a field means at a point, in long double: a second evaluator, by the definition of graphs
// and trees.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "eval/wide.h"
#include "field/field.h"

namespace oracle {

using eval::Extended;

class WideField {
public:
    using Point = std::array<Extended, 3>;

    /// A sheet's value, and whether the point is in all solids that it is clipped by.
    struct Sheet {
        Extended value;
        bool kept = true;
    };
    struct Content {
        Extended solid = numeric::infinity;  ///< at most 0 inside
        std::vector<Sheet> sheets;           ///< always the same ones in the same order
    };

    WideField(const field::Field& field, std::vector<double> parameters);

    /// No escape-time sets may be below the root.
    Content at(const Point& point) { return content(field_.root, point); }

private:
    Content content(field::FieldId id, const Point& point);
    Extended solid(field::FieldId id, const Point& point) { return content(id, point).solid; }
    Extended iterate(const field::Iteration& node, const Point& point);
    Extended number(graph::NodeId root, const Point& point);
    void take(const Point& point);

    const field::Field& field_;
    std::vector<Extended> parameters_, variables_, values_;
    std::map<graph::NodeId, std::vector<graph::NodeId>> orders_;
    std::vector<Extended> arguments_;
};

}  // namespace oracle
