// SPDX-License-Identifier: MIT
// Families: many alike operands of one union, or of a minimum in a formula. Their numbers are data
// of the program instead of text, so that the text does not grow with the members and a point asks
// only those that can matter there.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "field/field.h"
#include "shader/generalisation.h"

namespace shader {

/// More kinds of members than this stay text.
inline constexpr std::size_t most_kinds = 8;

/// What the members of one kind have in common.
struct MemberKind {
    graph::NodeId value{};  ///< a distance, of the point and of the first `value_numbers` variables
    std::optional<field::Colour> colour{};  ///< their own, of all the variables
    std::vector<graph::VariableId> variables;
    std::size_t value_numbers = 0;
};

struct Member {
    std::size_t kind = 0;
    std::vector<graph::NodeId> numbers;  ///< what the kind's variables are: of no point
};

struct Family {
    std::vector<MemberKind> kinds;
    std::vector<Member> members;
    std::optional<graph::NodeId> width;  ///< of the smooth minimum, if it is one
};

/// Puts each run of alike distances among the operands of a union into a node of its own: the keys.
/// Differences A \ b \ c ... become A \ (b | c ...) for that. The leaves and their order stay. What
/// is below a blend is left alone. The graph gets the kinds' nodes.
std::map<field::FieldId, Family> gather_families(field::Field& field);

/// A minimum's operands as a family; nothing if they are not alike enough.
std::optional<Family> family_of(field::Field& field, const std::vector<bool>& depends,
                                const field::Minimum& minimum);

}  // namespace shader
