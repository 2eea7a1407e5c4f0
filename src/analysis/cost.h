// SPDX-License-Identifier: MIT
// How many operations a part of a scene takes.
#pragma once

#include <cstddef>

#include "field/field.h"

namespace analysis {

/// Operations of the graph, each shared one once in every leaf; the weight of an operator does not
/// count. Joining two fields counts as one operation, colours do not count.
struct Cost {
    std::size_t point = 0;    ///< at each point, beside the turns of iterations
    std::size_t turn = 0;     ///< in each turn of an iteration, summed over all iterations
    std::size_t hoisted = 0;  ///< once a frame: what does not depend on the point
};

Cost cost(const field::Field& field, field::FieldId id);

}  // namespace analysis
