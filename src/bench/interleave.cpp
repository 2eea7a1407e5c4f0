// SPDX-License-Identifier: MIT
#include "bench/interleave.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

namespace bench {

std::vector<std::vector<double>> interleave(std::span<const int> rounds, std::uint32_t seed,
                                            const std::function<double(std::size_t)>& draw) {
    const std::size_t count = rounds.size();
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<std::vector<double>> results(count);
    std::mt19937 random(seed);
    const int most = rounds.empty() ? 0 : *std::ranges::max_element(rounds);
    for (int round = 0; round < most; ++round) {
        // Not std::shuffle, whose order differs between standard libraries.
        for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
        for (const std::size_t i : order) {
            if (round < rounds[i]) results[i].push_back(draw(i));
        }
    }
    return results;
}

}  // namespace bench
