// SPDX-License-Identifier: MIT
// Which operands of a large union can matter where: lists for the cells of a grid (as in Keeter,
// "Massively parallel rendering of complex closed-form implicit surfaces", 2020, and Barbier et
// al., "Lipschitz Pruning", 2025, there for the nodes of a tree).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "analysis/region.h"
#include "eval/tape.h"

namespace analysis {

/// Operands by kinds: those of one kind have one tape and differ in some of its variables.
struct Operands {
    struct Kind {
        /// Of the point and `variables`; 1-Lipschitz in the point.
        const eval::Tape* value = nullptr;
        std::span<const graph::VariableId> variables;
        std::vector<std::vector<double>> numbers;  ///< of each variable: one for each of the kind
    };
    std::vector<Kind> kinds;
    std::vector<std::uint32_t> kind;   ///< of each operand
    std::vector<std::uint32_t> place;  ///< of each operand among those of its kind
};

struct ActiveLists {
    glm::dvec3 origin{0};               ///< the grid's low corner
    double size = 1;                    ///< of a cell
    glm::ivec3 count{1};                ///< cells along each axis
    std::vector<std::uint32_t> cells;   ///< the list of each cell, x fastest
    std::vector<std::uint32_t> begins;  ///< of each list in `operands`, and at last the end
    std::vector<std::uint32_t> operands;

    std::span<const std::uint32_t> of(std::size_t cell) const {
        const std::size_t list = cells[cell];
        return std::span(operands).subspan(begins[list], begins[list + 1] - begins[list]);
    }
};

/// Lists in ascending order, such that at every point of a cell the union of its list has the value
/// of the union of all operands; and, with a width, the polynomial smooth minimum of its list, one
/// operand after the other (field::smooth_union), that of all to 3e-8 of the width. Rigorous as far
/// as the operands are 1-Lipschitz, with a margin of 1e-6 of the region for the rounding of values
/// in single precision. The grid covers the region; cells that do not meet it may have an empty
/// list. Two threads.
ActiveLists active_lists(const Operands& operands, const Region& region,
                         std::optional<double> width);

}  // namespace analysis
