// SPDX-License-Identifier: MIT
// The arguments of a call that combines fields: each is lowered and checked where it is asked for.
// What is wrong is reported, and nothing is given. Internal to the library.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "formula/arguments.h"
#include "formula/set_operations.h"

namespace formula {

using Vector = std::array<graph::NodeId, 3>;

class CombinationArguments {
public:
    /// Nothing if the call does not fit the slots.
    static std::optional<CombinationArguments> of(Lowering& lowering, const Call& call,
                                                  std::span<const Slot> slots);

    /// Whether the argument of this slot stands in the call.
    bool has(std::size_t slot) const { return bound_[slot].has_value(); }
    base::SourceSpan span(std::size_t slot) const { return lowering_.span(*bound_[slot]); }

    std::optional<FieldOperand> field(std::size_t slot) const;
    /// Whether the argument is a field, as it is in a call with more fields than slots for them.
    bool is_field(std::size_t slot) const;
    /// `problem` is the sentence that tells what cannot be done with a sheet.
    std::optional<FieldOperand> solid(std::size_t slot, std::string_view problem) const;

    /// A number that may depend on the point.
    std::optional<graph::NodeId> number(std::size_t slot) const;
    /// A number that does not depend on the point, folded if it is known; `initial` if it is left
    /// out.
    std::optional<graph::NodeId> uniform(std::size_t slot,
                                         std::optional<double> initial = {}) const;
    /// The same above 0.
    std::optional<graph::NodeId> positive(std::size_t slot,
                                          std::optional<double> initial = {}) const;
    /// Three numbers that do not depend on the point.
    std::optional<Vector> vector(std::size_t slot) const;
    /// The same, not all 0: an axis, a normal.
    std::optional<Vector> direction(std::size_t slot) const;
    /// One number or three that do not depend on the point; all above 0.
    std::optional<std::vector<graph::NodeId>> one_or_three(std::size_t slot) const;
    /// A number, a phase of the palette, or three, red, green and blue; may depend on the point.
    std::optional<field::Colour> colour(std::size_t slot) const;
    /// What a function that the user wrote makes of the point.
    std::optional<Vector> map(std::size_t slot) const;

    /// Reports what is wrong with an argument; `message` follows "the argument '...' of '...'".
    void error(std::size_t slot, std::string_view message) const;

private:
    CombinationArguments(Lowering& lowering, const Call& call, std::span<const Slot> slots,
                         Bound bound)
        : lowering_(lowering), call_(call), slots_(slots), bound_(std::move(bound)) {}

    std::string subject(std::size_t slot) const;
    std::optional<std::vector<graph::NodeId>> components(std::size_t slot, std::size_t count,
                                                         bool may_be_one = false) const;
    bool is_positive(std::size_t slot, graph::NodeId number) const;

    Lowering& lowering_;
    const Call& call_;
    std::span<const Slot> slots_;
    Bound bound_;
};

}  // namespace formula
