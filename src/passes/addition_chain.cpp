// SPDX-License-Identifier: MIT
#include "passes/addition_chain.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace passes {
namespace {

using Table = std::array<int, largest_chained_exponent + 1>;

/// For each n the exponent before it in the power tree; 0 for 1.
constexpr Table power_tree() {
    Table before{};
    Table level{1};
    int level_size = 1;
    while (level_size > 0) {
        Table next{};
        int next_size = 0;
        for (int i = 0; i < level_size; ++i) {
            // The path from the root, the smallest first.
            Table path{};
            int length = 0;
            const int n = level[static_cast<std::size_t>(i)];
            for (int k = n; k > 0; k = before[static_cast<std::size_t>(k)]) {
                path[static_cast<std::size_t>(length++)] = k;
            }
            while (length > 0) {
                const int sum = n + path[static_cast<std::size_t>(--length)];
                if (sum > largest_chained_exponent) break;
                if (before[static_cast<std::size_t>(sum)] != 0) continue;
                before[static_cast<std::size_t>(sum)] = n;
                next[static_cast<std::size_t>(next_size++)] = sum;
            }
        }
        level = next;
        level_size = next_size;
    }
    return before;
}

constexpr Table tree = power_tree();

int before(int n) { return tree[static_cast<std::size_t>(n)]; }

/// Exponents that are there, and how they came.
class Sequence {
public:
    bool has(int n) const { return present_[static_cast<std::size_t>(n)]; }

    /// At most so many multiplications would add_chain do.
    int missing(int n) const {
        int count = 0;
        for (; n > 1; n = before(n)) count += !has(n);
        return count;
    }
    void add_chain(int n) {
        if (has(n)) return;
        add_chain(before(n));
        add_chain(n - before(n));  // missing where the exponent before came another way
        add({n, before(n), n - before(n)});
    }
    /// Adds n by its own chain, or as the sum of a present exponent and one that is near.
    void add_cheaply(int n) {
        if (has(n)) return;
        int best = missing(n), by = 0;
        for (int a = n - 1; a > 0; --a) {
            const int cost = 1 + missing(n - a);
            if (has(a) && cost < best) best = cost, by = a;
        }
        if (n % 2 == 0 && 1 + missing(n / 2) < best) by = n / 2;
        if (by == 0) return add_chain(n);
        add_chain(by);
        add_chain(n - by);
        if (!has(n)) add({n, by, n - by});
    }
    std::vector<ExponentSum> sums() const { return sums_; }

private:
    void add(const ExponentSum& sum) {
        assert(has(sum.a) && has(sum.b));
        present_[static_cast<std::size_t>(sum.sum)] = true;
        sums_.push_back(sum);
    }

    std::array<bool, largest_chained_exponent + 1> present_{false, true};
    std::vector<ExponentSum> sums_;
};

}  // namespace

std::vector<ExponentSum> addition_chain(int n) {
    assert(n >= 1 && n <= largest_chained_exponent);
    Sequence sequence;
    sequence.add_chain(n);
    return sequence.sums();
}

std::vector<ExponentSum> addition_sequence(std::span<const int> exponents) {
    std::vector<int> sorted(exponents.begin(), exponents.end());
    std::ranges::sort(sorted);
    Sequence upwards, chains;
    for (const int n : sorted) upwards.add_cheaply(n);
    for (const int n : sorted) chains.add_chain(n);
    return upwards.sums().size() <= chains.sums().size() ? upwards.sums() : chains.sums();
}

}  // namespace passes
