// SPDX-License-Identifier: MIT
#include "bench/interleave.h"

#include <numeric>
#include <random>
#include <utility>

namespace bench {

std::vector<std::vector<double>> interleave(std::size_t count, int rounds, std::uint32_t seed,
                                            const std::function<double(std::size_t)>& draw) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<std::vector<double>> results(count);
    std::mt19937 random(seed);
    for (int round = 0; round < rounds; ++round) {
        // Not std::shuffle, whose order differs between standard libraries.
        for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
        for (const std::size_t i : order) results[i].push_back(draw(i));
    }
    return results;
}

}  // namespace bench
