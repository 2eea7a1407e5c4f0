// SPDX-License-Identifier: MIT
// What a tracer needs to know about one formula, brick by brick.
#pragma once

#include "analysis/bricks.h"
#include "eval/tape.h"
#include "numeric/interval.h"

namespace analysis {

/// Of a formula over one brick with its margin. Where neither bound is finite, or `breaks` is true,
/// no step within the brick is certified.
struct BrickBounds {
    double lipschitz = numeric::infinity;          ///< rigorous: at least sup |grad f|
    double second_derivative = numeric::infinity;  ///< rigorous: the Hessian's spectral norm
    bool breaks = true;                            ///< f may be undefined or jump; false is a proof
    /// Heuristic: by a usual |f| in the brick, the certified step is a small part of it.
    bool stiff = true;

    bool certified() const { return !breaks && !stiff; }
};

struct LeafBricks {
    Bricks bricks;
    std::vector<BrickBounds> bounds;  ///< by BrickGrid::place; of bricks that are `surface`
};

/// Value, gradient and Hessian are enclosed over each brick that may hold a surface; where they
/// prove that it holds none (mean-value form), the brick is decided after all. With a budget that
/// is done over larger cells before, whose answers stay where it is over. `f` is the tape of the
/// leaf `id`, which is a formula. `parameters` is indexed by ParameterId. Where `walls_known`,
/// steps end where f jumps, and only being undefined counts as breaking.
LeafBricks leaf_bricks(const field::Field& field, field::FieldId id, const eval::Tape& f,
                       std::span<const double> parameters, const Region& region,
                       const BrickEffort& effort, bool walls_known = false);

}  // namespace analysis
