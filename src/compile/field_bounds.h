// SPDX-License-Identifier: MIT
// How fast the values of a field's parts change over the visible region: leaf by leaf by intervals,
// and from the leaves up by the rules for maps, sums and blends (K 14-17).
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "analysis/leaf_bounds.h"
#include "field/field.h"

namespace compile {

/// Of a distortion: the image, with the turn as a fourth root if there is one, and the
/// displacement.
struct DistortionTapes {
    eval::Tape image;
    std::optional<eval::Tape> displacement;
};

/// What the bounds of a field are found from, by node; made once for a field, good for all values
/// of its parameters.
struct BoundTapes {
    std::map<field::FieldId, eval::Tape> formulas;                       ///< that are no distances
    std::map<field::FieldId, std::vector<DistortionTapes>> distortions;  ///< of leaves
    std::map<field::FieldId, eval::Tape> displacements;                  ///< of blends
    std::map<field::FieldId, std::array<eval::Tape, 3>> cells;           ///< their points
};

BoundTapes bound_tapes(const field::Field& field);

/// Bounds over a region (nothing: all of space), found when they are first asked for. `parameters`
/// is indexed by ParameterId.
class FieldBounds {
public:
    using Path = std::vector<field::FieldId>;

    FieldBounds(const field::Field& field, const BoundTapes& tapes,
                std::optional<analysis::Region> region, std::span<const double> parameters,
                const analysis::Budget* budget = nullptr)
        : field_(field), tapes_(tapes), region_(region), parameters_(parameters) {
        effort_.budget = budget;
    }

    /// Of a formula that is no distance, in these cells (outermost first).
    const analysis::LeafBounds& of_leaf(field::FieldId leaf, const Path& cells);

    /// A Lipschitz constant of the value of any node; +infinity if none was found, and also where
    /// the value may jump. Rigorous as far as the estimates of iterations are 1-Lipschitz.
    double lipschitz(field::FieldId node, const Path& cells);

    /// The region seen in the coordinates of the innermost of the cells.
    const std::optional<analysis::Region>& region(const Path& cells);

private:
    using Place = std::pair<field::FieldId, Path>;

    analysis::LeafBounds leaf_bounds(field::FieldId leaf, const Path& cells);
    double of_distortions(field::FieldId leaf, const Path& cells);
    /// Of a displacement alone.
    double of_displacement(const eval::Tape& tapes, const Path& cells);

    const field::Field& field_;
    const BoundTapes& tapes_;
    std::optional<analysis::Region> region_;
    std::span<const double> parameters_;
    analysis::Effort effort_;
    std::map<Place, analysis::LeafBounds> leaves_;
    std::map<Path, std::optional<analysis::Region>> regions_;
};

}  // namespace compile
