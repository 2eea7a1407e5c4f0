// SPDX-License-Identifier: MIT
// Powers by the fewest multiplications.
#pragma once

#include <span>
#include <vector>

namespace passes {

inline constexpr int largest_chained_exponent = 64;

/// An exponent as a sum of two that are there already: one multiplication.
struct ExponentSum {
    int sum, a, b;
};

/// The multiplications for x^n, 1 <= n <= largest_chained_exponent. As few as possible: the paths
/// of the power tree are shortest addition chains for all n below 77 (D. E. Knuth, The Art of
/// Computer Programming, volume 2, 4.6.3).
std::vector<ExponentSum> addition_chain(int n);

/// The multiplications for all of these powers of one base, in an order in which they can be done.
/// No more than the chains of the exponents take together, fewer where one power helps another.
/// The fewest for most sets; finding them for any set is NP-hard (Downey, Leong, Sethi 1981).
std::vector<ExponentSum> addition_sequence(std::span<const int> exponents);

}  // namespace passes
