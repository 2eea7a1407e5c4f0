// SPDX-License-Identifier: MIT
// Timing many things side by side.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace bench {

/// Calls `draw` for each number i in the first rounds[i] rounds, once a round, in another order
/// each round, so that a slow moment of the machine hits all alike. What it returns, by number and
/// then by round. The orders follow from the seed.
std::vector<std::vector<double>> interleave(std::span<const int> rounds, std::uint32_t seed,
                                            const std::function<double(std::size_t)>& draw);

}  // namespace bench
