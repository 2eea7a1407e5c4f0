// SPDX-License-Identifier: MIT
// Which leaves, blends and cells a field has, numbered as its program names them.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "field/field.h"
#include "shader/family.h"

namespace shader {

/// A leaf where it stands in the tree; its number is the object's.
struct Object {
    field::FieldId id{};
    std::vector<field::FieldId> cells;  ///< above it, outermost first
    std::optional<std::size_t> blend;   ///< the number of the outermost blend above it
    bool is_member = false;             ///< of a family: its numbers are data
};

/// A family where it stands in the tree.
struct PlannedFamily {
    field::FieldId id{};
    std::vector<field::FieldId> cells;  ///< above it, outermost first
    std::size_t first_object = 0;       ///< its members' objects follow one another
};

/// A blend with none above it.
struct OuterBlend {
    field::FieldId id{};
    std::vector<field::FieldId> cells;  ///< above it, outermost first
    std::size_t first_object = 0;       ///< of those below
    bool escapes = false;               ///< an escape-time set is below
    bool iterates = false;              ///< an iteration is below: gradients by differences
};

struct FieldPlan {
    std::vector<Object> objects;          ///< from left to right
    std::vector<OuterBlend> blends;       ///< likewise
    std::vector<field::FieldId> cells;    ///< each once
    std::vector<field::FieldId> mixes;    ///< all blends, also those below others, each once
    std::vector<PlannedFamily> families;  ///< from left to right

    std::size_t cells_number(field::FieldId id) const;
};

FieldPlan field_plan(const field::Field& field, const std::map<field::FieldId, Family>& families);

}  // namespace shader
