// SPDX-License-Identifier: MIT
// Chains against the shortest ones, found by trying all.
#include "passes/addition_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace passes {
namespace {

/// True if some chain with `left` more sums reaches n. In a shortest chain up to 12,508 each sum
/// has the one before as a part (Clift 2011), so only those are tried.
bool reaches(std::vector<int>& chain, int n, int left) {
    const int last = chain.back();
    if (last == n) return true;
    if (left == 0 || last << left < n) return false;
    for (std::size_t i = chain.size(); i-- > 0;) {
        if (last + chain[i] > n) continue;
        chain.push_back(last + chain[i]);
        if (reaches(chain, n, left - 1)) return true;
        chain.pop_back();
    }
    return false;
}

std::size_t shortest(int n) {
    for (int length = 0;; ++length) {
        std::vector<int> chain{1};
        if (reaches(chain, n, length)) return static_cast<std::size_t>(length);
    }
}

/// True if each sum has its parts before it, and all of the exponents are there.
bool is_valid(const std::vector<ExponentSum>& sums, const std::vector<int>& exponents) {
    std::set<int> there{1};
    for (const auto& [sum, a, b] : sums) {
        if (sum != a + b || !there.contains(a) || !there.contains(b)) return false;
        if (!there.insert(sum).second) return false;
    }
    return std::ranges::all_of(exponents, [&](int n) { return there.contains(n); });
}

TEST(AdditionChain, is_as_short_as_can_be) {
    for (int n = 1; n <= largest_chained_exponent; ++n) {
        const std::vector<ExponentSum> chain = addition_chain(n);
        EXPECT_TRUE(is_valid(chain, {n})) << n;
        EXPECT_EQ(chain.size(), shortest(n)) << n;
    }
}

TEST(AdditionChain, has_the_lengths_of_the_books) {
    EXPECT_EQ(addition_chain(1).size(), 0U);
    EXPECT_EQ(addition_chain(7).size(), 4U);
    EXPECT_EQ(addition_chain(15).size(), 5U) << "squaring takes 6";
    EXPECT_EQ(addition_chain(23).size(), 6U) << "squaring takes 7";
    EXPECT_EQ(addition_chain(33).size(), 6U);
    EXPECT_EQ(addition_chain(63).size(), 8U);
    EXPECT_EQ(addition_chain(64).size(), 6U);
}

TEST(AdditionSequence, shares_what_exponents_have_in_common) {
    const auto length = [](std::vector<int> exponents) {
        const std::vector<ExponentSum> sums = addition_sequence(exponents);
        EXPECT_TRUE(is_valid(sums, exponents));
        return sums.size();
    };
    EXPECT_EQ(length({2, 4, 6}), 3U);
    EXPECT_EQ(length({2, 3, 5}), 3U);
    EXPECT_EQ(length({4, 5, 9}), 4U);
    EXPECT_EQ(length({7, 8}), 5U);
    EXPECT_EQ(length({15, 16}), 6U);
    EXPECT_EQ(length({8, 7, 6, 5, 4, 3, 2}), 7U);
}

TEST(AdditionSequence, takes_no_more_than_the_chains_together) {
    constexpr unsigned seed = 17;
    std::mt19937 random(seed);
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<int> exponents;
        std::set<int> together;
        const int size = 1 + static_cast<int>(random() % 6);
        for (int i = 0; i < size; ++i) {
            exponents.push_back(1 + static_cast<int>(random() % largest_chained_exponent));
            for (const ExponentSum& sum : addition_chain(exponents.back())) {
                together.insert(sum.sum);
            }
        }
        const std::vector<ExponentSum> sums = addition_sequence(exponents);
        ASSERT_TRUE(is_valid(sums, exponents)) << "seed " << seed << ", trial " << trial;
        ASSERT_LE(sums.size(), together.size()) << "seed " << seed << ", trial " << trial;
    }
}

}  // namespace
}  // namespace passes
