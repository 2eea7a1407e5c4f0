// SPDX-License-Identifier: MIT
// A budget that counts instead of looking at a clock.
#pragma once

#include <atomic>
#include <memory>

#include "analysis/budget.h"

namespace analysis {

/// Is over when it has been asked so often.
inline Budget over_after(int questions) {
    const auto left = std::make_shared<std::atomic<int>>(questions);
    return Budget([left] { return (*left)-- <= 0; });
}

}  // namespace analysis
