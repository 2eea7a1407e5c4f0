// SPDX-License-Identifier: MIT
#include "contract/operator_table.h"

#include <algorithm>
#include <cmath>

namespace contract {
namespace {

using graph::Op;

constexpr Range large{-1e18, 1e18};
constexpr Range turns{-50000, 50000};
constexpr Range unit{-1, 1};
constexpr Range exponents{-80, 80};

// One rounding in single precision is 6e-8. Every bound is about twice the worst error that was
// found with llvmpipe; docs/numerics.md has both.
constexpr std::array table{
    Row{Op::neg, {large}, Unit::none, 0},
    Row{Op::add, {large, large}, Unit::relative, 1.2e-7},
    Row{Op::sub, {large, large}, Unit::relative, 1.2e-7},
    Row{Op::mul, {large, large}, Unit::relative, 1.2e-7},
    Row{Op::div, {large, large}, Unit::relative, 1.2e-7},
    Row{Op::pow, {Range{-1e6, 1e6}, Range{-64, 64}}, Unit::power, 4e-7},
    Row{Op::sqrt, {Range{0, 1e30}}, Unit::relative, 1.2e-7},
    Row{Op::cbrt, {Range{-1e30, 1e30}}, Unit::relative, 2e-7},
    Row{Op::hypot, {large, large}, Unit::relative, 3e-7},
    Row{Op::hypot3, {large, large, large}, Unit::relative, 3e-7},
    Row{Op::sin, {turns}, Unit::absolute, 2e-7},
    Row{Op::cos, {turns}, Unit::absolute, 2e-7},
    Row{Op::tan, {turns}, Unit::slope, 3e-7},
    Row{Op::asin, {unit}, Unit::relative, 5e-7},
    Row{Op::acos, {unit}, Unit::absolute, 6e-7},
    Row{Op::atan, {large}, Unit::relative, 4e-7},
    Row{Op::atan2, {large, large}, Unit::relative, 4e-7},
    Row{Op::sinh, {exponents}, Unit::relative, 6e-6},
    Row{Op::cosh, {exponents}, Unit::relative, 6e-6},
    Row{Op::tanh, {large}, Unit::relative, 4e-7},
    Row{Op::exp, {exponents}, Unit::relative, 6e-6},
    Row{Op::log, {Range{1e-30, 1e30}}, Unit::mixed, 5e-7},
    Row{Op::abs, {large}, Unit::none, 0},
    Row{Op::sign, {large}, Unit::none, 0},
    Row{Op::floor, {large}, Unit::none, 0},
    Row{Op::ceil, {large}, Unit::none, 0},
    Row{Op::min, {large, large}, Unit::none, 0},
    Row{Op::max, {large, large}, Unit::none, 0},
    Row{Op::ratio, {large, large}, Unit::relative, 1.2e-7},
    Row{Op::select_less, {large, large, large, large}, Unit::none, 0},
};

}  // namespace

std::span<const Row> operator_table() { return table; }

const Row* find_row(Op op) {
    const auto found = std::ranges::find(table, op, &Row::op);
    return found == table.end() ? nullptr : &*found;
}

bool is_allowed(Op op, const Arguments& arguments) {
    return op != Op::ratio || std::isnan(arguments[0]) || std::isnan(arguments[1]) ||
           std::abs(arguments[0]) <= arguments[1];
}

bool is_promised(const Row& row, const Arguments& arguments) {
    double largest = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(graph::facts(row.op).arity); ++i) {
        if (!row.ranges[i].contains(arguments[i])) return false;
        largest = std::max<double>(largest, std::abs(arguments[i]));
    }
    const bool is_length = row.op == Op::hypot || row.op == Op::hypot3;
    return is_allowed(row.op, arguments) && (!is_length || largest >= least_length);
}

double size_of(Unit unit, const Arguments& arguments, double value) {
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
            return size * (1 + std::abs(arguments[1]) + std::abs(std::log(size)));
    }
    return 0;
}

const char* name_of(Unit unit) {
    switch (unit) {
        case Unit::none:
            return "exact";
        case Unit::relative:
            return "relative";
        case Unit::absolute:
            return "absolute";
        case Unit::mixed:
            return "relative or absolute";
        case Unit::slope:
            return "of 1 + value^2";
        case Unit::power:
            return "of value (1 + |b| + |log value|)";
    }
    return "";
}

}  // namespace contract
