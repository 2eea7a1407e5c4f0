// SPDX-License-Identifier: MIT
// A field as its first hit along a ray is looked for: a union of solids and of sheets, each by
// itself, all in world coordinates, for some values of the parameters.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "eval/tape.h"
#include "field/field.h"

namespace oracle {

/// An escape-time leaf as tapes; those of `field::Iteration`. `point` has the three coordinates
/// that it is seen in.
struct Loop {
    std::vector<graph::VariableId> state;
    eval::Tape point, start, step, escape, distance;
    bool escapes = false;
    double limit = 0;
};

/// A node of a tree of solids. Its value is below or at 0 inside; where it is undefined is outside.
struct Solid {
    enum class What { formula, loop, least, most, complement, blend };
    What what = What::formula;
    std::size_t source = 0;             ///< of a formula and a blend its tape, of a loop its number
    std::vector<std::size_t> operands;  ///< solids
    std::vector<graph::VariableId> values{};  ///< of a blend: its operands' in its tape
    bool distance = false;                    ///< of a formula: 1-Lipschitz
    int object = -1;                          ///< of a leaf
    bool has_loops = false;                   ///< at or below
};

/// The zeros of a formula, where all guards are defined and not 0, inside of a solid.
struct Sheet {
    std::size_t source = 0;             ///< a tape
    std::vector<std::size_t> guards{};  ///< tapes
    std::optional<std::size_t> clip{};  ///< a solid
    int object = -1;
};

/// A solid that is a part of the union.
struct Part {
    std::size_t solid = 0;
    /// At least 0 inside of the cell where the point is, affine in it; only of a solid with loops.
    std::vector<std::size_t> walls{};
};

struct Shape {
    std::vector<double> parameters;  ///< indexed by ParameterId
    std::size_t variable_count = 0;
    std::vector<eval::Tape> tapes;
    std::vector<Loop> loops;
    std::vector<Solid> solids;
    std::vector<Part> parts;
    std::vector<Sheet> sheets;
};

/// Takes apart a field. `parameters` is indexed by ParameterId.
Shape make_shape(const field::Field& field, std::span<const double> parameters);

}  // namespace oracle
