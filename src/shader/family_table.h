// SPDX-License-Identifier: MIT
// What the CPU needs to know of families to feed their program: the numbers of their members, and
// which of them can matter where.
#pragma once

#include <optional>
#include <vector>

#include "eval/tape.h"
#include "field/field.h"

namespace shader {

/// One family. A row is `texels` of four floats long and holds a member's numbers and at its end,
/// where there are several, the kind, and the object, if members are objects.
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
    graph::VariableId variable{};               ///< stands for the minimum in a formula's outline
};

/// The families that one leaf is made of, or a union. The program's texels hold for each tree the
/// rows of its families, heads, and lists. A head is `head_texels` long. The first head is that of
/// all rows; then follow those of the cells of analysis::ActiveCells. A cell that is
///   divided  has 0 as the fourth number of its head, and the first is -(its first cell's head);
///   far      has its value there, and its slope before it;
///   listed   has 0 there as well; where its list begins, and then for each family where it ends in
///            that, are the numbers of the head but the fourth. Lists hold copies of rows.
struct FamilyTree {
    std::size_t first = 0, count = 1;     ///< among the families
    std::optional<eval::Tape> outline{};  ///< of a leaf, by the families' variables
    bool may_be_far = false;              ///< the program asks for no more than a bound there
    /// The cells that it is in, outermost first: the tree is in their coordinates.
    std::vector<field::FieldId> cells{};

    /// Where a head's number stands: those of list ends leave the fourth one out.
    static std::size_t end_place(std::size_t family) {
        return family < 2 ? family + 1 : family + 2;
    }
    std::size_t head_texels() const { return end_place(count - 1) / 4 + 1; }
};

/// What the program is told of a family besides the texels, as FieldValue::component numbers it:
/// all but the last of its tree.
enum class FamilyHead {
    origin_x,
    origin_y,
    origin_z,
    inverse_size,  ///< of a cube of the tree
    count_x,       ///< cubes along each axis
    count_y,
    count_z,
    heads,  ///< the first texel of the heads
    rows,   ///< the first texel of the rows
};
inline constexpr std::size_t family_head_size = 9;

}  // namespace shader
