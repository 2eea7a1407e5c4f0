// SPDX-License-Identifier: MIT
// Finds out which expression is which argument of a primitive or a combination. Internal to the
// library.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formula/lowering.h"

namespace formula {

/// What may be given to a call.
struct Slot {
    std::string_view name;  ///< empty if it cannot be given by name
    bool required = false;
};

/// One expression or none per slot; nothing if there was an error. In a call of fields `name = ...`
/// is an argument by name only if a slot has this name (otherwise it is a surface); in a call of
/// numbers always.
using Bound = std::vector<std::optional<ExpressionId>>;
std::optional<Bound> bind(Lowering& lowering, const Call& call, std::span<const Slot> slots,
                          bool of_fields);

/// Of a function that the user defines: `name = ...` is an argument by name unless the name is a
/// coordinate that no slot has.
std::optional<Bound> bind_to_user_function(Lowering& lowering, const Call& call,
                                           std::span<const Slot> slots);

/// Lowers all arguments, for the errors inside of them.
void lower_arguments(Lowering& lowering, const Call& call);

/// The components of an argument that is the same at every point, as nodes: exactly `components`,
/// one is written as a number and more as a tuple; a single number in place of a tuple too if that
/// `may_be_one`. Constants must be finite.
std::optional<std::vector<graph::NodeId>> uniform_components(Lowering& lowering, const Call& call,
                                                             std::string_view argument,
                                                             ExpressionId value,
                                                             std::size_t components,
                                                             bool may_be_one = false);

}  // namespace formula
