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

/// Turns of q -> q^2 + c until |q|^2 is above a bound (oracle/quadratic.h).
struct QuadraticTurns {
    std::size_t size = 4;  ///< of q: 2 or 4
    /// An expression with a root for each component of q at the start, then one for each of c, then
    /// minus the bound.
    std::size_t source = 0;
};

/// An escape-time leaf as tapes; those of `field::Iteration`. `point` has the three coordinates
/// that it is seen in.
struct Loop {
    std::vector<graph::VariableId> state;
    eval::Tape point, start, step, escape, distance;
    bool escapes = false;
    double limit = 0;
    std::optional<QuadraticTurns> quadratic{};  ///< then its sign can be proven
};

/// An operator that may jump (floor, a choice, ...). Its value is a variable of all expressions, so
/// that each side of a jump can be looked at by itself.
struct Cut {
    graph::Op op{};
    graph::VariableId variable{};
    std::size_t arguments = 0;  ///< an expression with a root for each argument
};

/// Of the point, of parameters, and of the cuts that it lists, each before those that need it.
struct Expression {
    eval::Tape tape;
    std::vector<std::size_t> cuts;
};

/// A node of a tree of solids. Its value is below or at 0 inside; where it is undefined is outside.
struct Solid {
    enum class What { formula, loop, least, most, complement, blend };
    What what = What::formula;
    std::size_t source = 0;  ///< of a formula and a blend its expression, of a loop its number
    std::vector<std::size_t> operands{};      ///< solids
    std::vector<graph::VariableId> values{};  ///< of a blend: its operands' in its expression
    bool distance = false;                    ///< of a formula: 1-Lipschitz
    int object = -1;                          ///< of a leaf
    bool has_loops = false;                   ///< at or below
    bool estimated = false;                   ///< at or below, its sign rests on an estimate
    std::vector<std::size_t> cuts{};          ///< of all that is below
};

/// The zeros of an expression, where all guards are defined and not 0, inside of a solid.
struct Sheet {
    std::size_t source = 0;             ///< an expression
    std::vector<std::size_t> guards{};  ///< expressions
    std::optional<std::size_t> clip{};  ///< a solid
    int object = -1;
};

/// A solid that is a part of the union.
struct Part {
    std::size_t solid = 0;
    /// Expressions, at least 0 inside of the cell where the point is, affine in it; only of a solid
    /// with loops.
    std::vector<std::size_t> walls{};
};

struct Shape {
    std::vector<double> parameters;  ///< indexed by ParameterId
    std::size_t variable_count = 0;
    std::vector<Expression> expressions;
    std::vector<Cut> cuts;
    std::vector<Loop> loops;
    std::vector<Solid> solids;
    std::vector<Part> parts;
    std::vector<Sheet> sheets;
};

/// Takes apart a field. `parameters` is indexed by ParameterId.
Shape make_shape(const field::Field& field, std::span<const double> parameters);

/// Whether there are escape-time sets that nothing is proven of.
bool is_heuristic(const Shape& shape);

}  // namespace oracle
