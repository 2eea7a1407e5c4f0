// SPDX-License-Identifier: MIT
#include "bench/pareto.h"

#include <algorithm>

namespace bench {

std::vector<bool> pareto_front(std::span<const Trade> trades) {
    std::vector<bool> front;
    for (const Trade& trade : trades) {
        front.push_back(std::ranges::none_of(trades, [&](const Trade& other) {
            const bool as_good = other.seconds <= trade.seconds && other.error <= trade.error;
            return as_good && (other.seconds < trade.seconds || other.error < trade.error);
        }));
    }
    return front;
}

}  // namespace bench
