// SPDX-License-Identifier: MIT
// Which operands of large unions can matter where, and where none do because the surface is far:
// a tree of cells (as in Keeter, "Massively parallel rendering of complex closed-form implicit
// surfaces", 2020, and Barbier et al., "Lipschitz Pruning", 2025, there for the nodes of a tree of
// operations; far cells as in the latter).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "analysis/budget.h"
#include "analysis/operand_values.h"
#include "analysis/region.h"
#include "eval/tape.h"

namespace analysis {

/// The minimum of many operands.
struct ManyOperands {
    Operands operands;
    /// If given, it is the polynomial smooth minimum of one operand after the other
    /// (field::smooth_union).
    std::optional<double> width{};
    graph::VariableId variable{};  ///< stands for it in the outline
};

/// A field made of such minima.
struct Composition {
    std::vector<ManyOperands> minima;  ///< at least one
    /// The field, of the point and of the minima's variables; the only minimum itself if null.
    const eval::Tape* outline = nullptr;
    std::span<const double> parameters{};  ///< of the outline, by ParameterId
    /// The field is 1-Lipschitz, and far from its surface a bound of its value is enough.
    bool may_be_far = false;
    bool inside_too = false;  ///< also where it is negative
};

/// A box in cubes, `count` along each axis, each of them a node; a node is cut into cells_aside^3
/// cells, and a cell may be a node again.
struct ActiveCells {
    static constexpr int cells_aside = 4;
    static constexpr std::uint32_t cells_a_node = 64;

    struct Cell {
        enum class Kind : std::uint8_t {
            everything,  ///< outside of the region: all operands, in no list
            listed,      ///< operands are in the list `place`
            far,         ///< where it may be
            divided,     ///< its first cell is `place`
        };
        Kind kind = Kind::everything;
        std::uint32_t place = 0;
        /// Of a far cell: the field at its middle (rigorous), and about how it changes from there
        /// (heuristic: within a hundredth of the value at some points of the cell).
        double value = 0;
        glm::dvec3 gradient{0};
    };

    glm::dvec3 origin{0};  ///< the low corner
    double size = 1;       ///< of a cube
    glm::ivec3 count{1};   ///< cubes
    std::vector<Cell>
        cells;  ///< nodes one after the other, their cells x fastest; the cubes' first
    /// Of each list, where its operands of each minimum begin, one after the other, and at last
    /// where the last ones end.
    std::vector<std::uint32_t> begins{0};
    std::vector<std::uint32_t> operands;
    std::size_t minima = 1;

    /// The smallest cell that a point of the box is in, and its middle.
    struct Place {
        std::size_t cell = 0;
        glm::dvec3 middle{0};
    };
    Place at(const glm::dvec3& p) const;
    /// The operands of one of the minima in a list.
    std::span<const std::uint32_t> of(std::size_t list, std::size_t minimum = 0) const {
        const std::size_t place = list * minima + minimum;
        return std::span(operands).subspan(begins[place], begins[place + 1] - begins[place]);
    }
};

/// Lists in ascending order, such that at every point of a cell each minimum of its list has the
/// value of the minimum of all operands, and with a width that of all to 3e-8 of the width. In a
/// far cell |value| - |p - middle| bounds the field's size from below, whose sign is that of the
/// value. Rigorous as far as operands and field are 1-Lipschitz, with a margin of 1e-6 of the
/// region for the rounding in single precision. Without a budget work is counted, so that the same
/// is found on every machine, with any number of cores; with one cubes have small cells only where
/// lists are long near the surface first, and keep those where it is over.
ActiveCells active_cells(const Composition& composition, const Region& region,
                         const Budget* budget = nullptr);

}  // namespace analysis
