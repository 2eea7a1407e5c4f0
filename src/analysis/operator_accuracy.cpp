// SPDX-License-Identifier: MIT
#include "analysis/operator_accuracy.h"

#include <algorithm>
#include <cmath>

namespace analysis {
namespace {

using graph::Op;
using numeric::Interval;

constexpr Range large{-1e18, 1e18};
constexpr Range turns{-50000, 50000};
constexpr Range unit{-1, 1};
constexpr Range exponents{-80, 80};

// One rounding in single precision is 6e-8. Every bound is about twice the worst error that was
// found with llvmpipe; docs/numerics.md has both.
constexpr std::array table{
    Accuracy{Op::neg, {large}, Unit::none, 0},
    Accuracy{Op::add, {large, large}, Unit::relative, 1.2e-7},
    Accuracy{Op::sub, {large, large}, Unit::relative, 1.2e-7},
    Accuracy{Op::mul, {large, large}, Unit::relative, 1.2e-7},
    Accuracy{Op::div, {large, large}, Unit::relative, 1.2e-7},
    Accuracy{Op::pow, {Range{-1e6, 1e6}, Range{-64, 64}}, Unit::power, 4e-7},
    Accuracy{Op::sqrt, {Range{0, 1e30}}, Unit::relative, 1.2e-7},
    Accuracy{Op::cbrt, {Range{-1e30, 1e30}}, Unit::relative, 2e-7},
    Accuracy{Op::hypot, {large, large}, Unit::relative, 3e-7},
    Accuracy{Op::hypot3, {large, large, large}, Unit::relative, 3e-7},
    Accuracy{Op::sin, {turns}, Unit::absolute, 2e-7},
    Accuracy{Op::cos, {turns}, Unit::absolute, 2e-7},
    Accuracy{Op::tan, {turns}, Unit::slope, 3e-7},
    Accuracy{Op::asin, {unit}, Unit::relative, 5e-7},
    Accuracy{Op::acos, {unit}, Unit::absolute, 6e-7},
    Accuracy{Op::atan, {large}, Unit::relative, 4e-7},
    Accuracy{Op::atan2, {large, large}, Unit::relative, 4e-7},
    Accuracy{Op::sinh, {exponents}, Unit::relative, 6e-6},
    Accuracy{Op::cosh, {exponents}, Unit::relative, 6e-6},
    Accuracy{Op::tanh, {large}, Unit::relative, 4e-7},
    Accuracy{Op::exp, {exponents}, Unit::relative, 6e-6},
    Accuracy{Op::log, {Range{1e-30, 1e30}}, Unit::mixed, 5e-7},
    Accuracy{Op::abs, {large}, Unit::none, 0},
    Accuracy{Op::sign, {large}, Unit::none, 0},
    Accuracy{Op::floor, {large}, Unit::none, 0},
    Accuracy{Op::ceil, {large}, Unit::none, 0},
    Accuracy{Op::min, {large, large}, Unit::none, 0},
    Accuracy{Op::max, {large, large}, Unit::none, 0},
    Accuracy{Op::ratio, {large, large}, Unit::relative, 1.2e-7},
    Accuracy{Op::select_less, {large, large, large, large}, Unit::none, 0},
};

}  // namespace

std::span<const Accuracy> operator_accuracies() { return table; }

const Accuracy* accuracy_of(Op op) {
    const auto found = std::ranges::find(table, op, &Accuracy::op);
    return found == table.end() ? nullptr : &*found;
}

bool is_promised(const Accuracy& accuracy, const std::array<Interval, graph::max_arity>& box) {
    double most = 0;
    for (std::size_t i = 0; i < graph::arity(accuracy.op); ++i) {
        const Range& range = accuracy.ranges[i];
        if (!range.contains(box[i].lo) || !range.contains(box[i].hi)) return false;
        most = std::max(most, mignitude(box[i]));
    }
    const bool is_length = accuracy.op == Op::hypot || accuracy.op == Op::hypot3;
    return !is_length || most >= least_length;
}

double size_of(Unit unit, double exponent, double value) {
    const double size = std::abs(value);
    switch (unit) {
        case Unit::none:
        case Unit::absolute:
            return 1;
        case Unit::relative:
            return size;
        case Unit::mixed:
            return std::max(1.0, size);
        case Unit::slope:
            return 1 + size * size;
        case Unit::power:
            return size * (1 + std::abs(exponent) + std::abs(std::log(size)));
    }
    return 0;
}

double largest_size(Unit unit, const Interval& exponent, const Interval& value) {
    const double size = magnitude(value);
    if (unit != Unit::power) return size_of(unit, 0, size);
    // s (1 + |b| + |log s|) grows with s, but for the bump of s |log s|, which is at most 1 / e.
    const double steep = size > 0 ? size * std::abs(std::log(size)) : 0;
    return size * (1 + magnitude(exponent)) + std::max(steep, std::min(size, 1.0));
}

}  // namespace analysis
