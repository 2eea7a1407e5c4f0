// SPDX-License-Identifier: MIT
// What the CPU needs to know of a family to feed its program: the numbers of its members, and which
// of them can matter where.
#pragma once

#include <optional>
#include <vector>

#include "eval/tape.h"
#include "field/field.h"

namespace shader {

/// The layout of the program's texels of four floats: for each family its rows, one a member, its
/// heads, and its lists. A row is `texels` long and holds the member's numbers and at its
/// end, where there are several, the kind, and the object, if members are objects. A head holds the
/// first texel of a list and the one behind its end; the first head is that of the rows themselves,
/// and one for each cell of the grid follows, x fastest. A list holds copies of rows.
struct FamilyTable {
    struct Kind {
        eval::Tape value;  ///< of the point and the variables
        std::vector<graph::VariableId> variables;
    };
    std::vector<Kind> kinds;
    std::vector<std::size_t> members;  ///< the kind of each
    std::vector<std::size_t> sizes;    ///< how many numbers each has
    /// Of all members, one after the other, and at last the width of a smooth minimum.
    eval::Tape numbers;
    bool is_smooth = false;
    std::size_t texels = 0;
    std::optional<std::size_t> first_object{};  ///< if members are objects
    /// The cells that the family is in, outermost first: the grid is in their coordinates.
    std::vector<field::FieldId> cells;
};

/// What the program is told of a family besides the texels, as FieldValue::component numbers it.
enum class FamilyHead {
    origin_x,
    origin_y,
    origin_z,
    inverse_size,  ///< of a cell of the grid
    count_x,       ///< cells along each axis
    count_y,
    count_z,
    heads,  ///< the first texel of the heads
    rows,   ///< the first texel of the rows
};
inline constexpr std::size_t family_head_size = 9;

}  // namespace shader
