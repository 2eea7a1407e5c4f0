// SPDX-License-Identifier: MIT
#include "analysis/budget.h"

#include <chrono>

namespace analysis {

Budget Budget::of_seconds(double seconds) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    return Budget([end] { return Clock::now() >= end; });
}

}  // namespace analysis
