// SPDX-License-Identifier: MIT
// Which of some trades between time and error are worth making.
#pragma once

#include <span>
#include <vector>

namespace bench {

struct Trade {
    double seconds = 0;
    double error = 0;
};

/// For each trade whether it is on the Pareto front: no other is better in one and at least as good
/// in the other. Of equal ones all are.
std::vector<bool> pareto_front(std::span<const Trade> trades);

}  // namespace bench
