// SPDX-License-Identifier: MIT
// Where a picture is wrong, as rectangles that are laid over it.
#pragma once

#include <vector>

#include "oracle/metrics.h"
#include "oracle/reference.h"

namespace studio {

/// Pixels of one judgement, from the left and the top of the reference.
struct MarkedArea {
    int x = 0, y = 0, width = 0, height = 0;
    oracle::Judgement judgement{};  ///< missed, phantom or moved; excused: undecided

    friend bool operator==(const MarkedArea&, const MarkedArea&) = default;
};

/// Covers every wrong or undecided pixel once, and no other. Fragile pixels are left out: there are
/// some along every outline, and they tell nothing. The metrics must be of this reference.
std::vector<MarkedArea> marked_areas(const oracle::Reference& reference,
                                     const oracle::Metrics& metrics);

}  // namespace studio
