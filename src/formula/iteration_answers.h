// SPDX-License-Identifier: MIT
// What an iteration answers after its last turn: the distance, given or derived, and the colour.
// Internal to the library.
#pragma once

#include <optional>

#include "formula/lowering.h"

namespace formula {

/// An iteration whose turns are lowered and whose answers are not.
struct Turns {
    field::Iteration iteration{};  ///< the orbit, which is the first name, comes first in the state
    Value orbit{};                 ///< its variables
    graph::VariableId growth{};    ///< stands for |dz/dp|, z the orbit and p the point
    graph::VariableId across{};    ///< for the same with what Orbit::across counts
    graph::VariableId done{};      ///< the number of turns that are done
    std::optional<Orbit> start{}, next{};  ///< what is known of the orbit first and after a turn
    /// `until large > small`; other conditions are a number that is above 0 where they hold
    struct Until {
        graph::NodeId large{}, small{};
        base::SourceSpan span;
    };
    std::optional<Until> until{};
    bool failed = false;  ///< there is an error, and there will be no field
};

/// The field of an iteration.
Value lower_answers(Lowering& lowering, const Iterate& iterate, Turns turns, base::SourceSpan span);

}  // namespace formula
