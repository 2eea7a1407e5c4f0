// SPDX-License-Identifier: MIT
// Each operator on intervals against the same operator at points from within, on doubles and in
// extended precision.
#include "eval/operators.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "eval/random_expression.h"
#include "eval/wide.h"

namespace eval {
namespace {

using numeric::Interval;

constexpr unsigned seed = 20240229;
constexpr int boxes = 4000;
constexpr int samples = 1'000'000;  // of every operator
constexpr int samples_a_box = 40;

using Box = std::array<Interval, graph::max_arity>;
using Point = std::array<double, graph::max_arity>;

Interval random_interval(Random& random) {
    const bool awkward = random() % 2 == 0;
    const auto number = [&] { return awkward ? awkward_number(random) : ordinary_number(random); };
    const double a = number(), b = random() % 4 == 0 ? a : number();
    return {std::min(a, b), std::max(a, b)};
}

/// A number of the interval: its ends and their neighbours most of the time.
double sample(const Interval& from, Random& random) {
    const double part = std::uniform_real_distribution<double>(0, 1)(random);
    double number = 0;
    switch (random() % 6) {
        case 0:
            return from.lo;
        case 1:
            return from.hi;
        case 2:
            number = numeric::next_up(from.lo);
            break;
        case 3:
            number = numeric::next_down(from.hi);
            break;
        case 4:
            number = awkward_number(random);
            break;
        default:
            number = from.lo + part * (from.hi - from.lo);
            break;
    }
    return number == number ? std::clamp(number, from.lo, from.hi) : from.lo;
}

/// True where an operator's precondition does not hold.
bool is_excluded(graph::Op op, const Point& p) {
    return op == graph::Op::ratio && !(std::abs(p[0]) <= p[1]);
}
/// True where it holds nowhere.
bool is_excluded(graph::Op op, const Box& box) {
    return op == graph::Op::ratio && mignitude(box[0]) > box[1].hi;
}

Interval over(graph::Op op, const Box& box) {
    return apply<Interval>(op, box[0], box[1], box[2], box[3]);
}
double at(graph::Op op, const Point& p) { return apply<double>(op, p[0], p[1], p[2], p[3]); }

std::string describe(graph::Op op, const Box& box) {
    std::string text = std::string(graph::facts(op).name) + ", seed " + std::to_string(seed) + ":";
    for (int i = 0; i < graph::facts(op).arity; ++i) {
        text += " [" + ::testing::PrintToString(box[static_cast<std::size_t>(i)].lo) + ", " +
                ::testing::PrintToString(box[static_cast<std::size_t>(i)].hi) + "]";
    }
    return text;
}

Extended exactly(graph::Op op, const Point& p) {
    return apply_by_type<Extended>(op, {p[0], p[1], p[2], p[3]});
}

/// A value at a point must be in the interval; none, or a pole's infinity, needs `partial`.
bool is_covered(const Interval& interval, double value) {
    if (std::isnan(value)) return interval.partial;
    if (std::isinf(value) && interval.partial) return true;
    return interval.contains(value);
}
/// The same for the exact value, whatever size it has.
bool is_covered(const Interval& interval, const Extended& value) {
    if (value.is_nan() || !value.is_finite()) return is_covered(interval, double(value));
    return interval.lo <= value.number && value.number <= interval.hi;
}

class Operators : public ::testing::TestWithParam<graph::Op> {};

TEST_P(Operators, intervals_contain_every_sampled_value) {
    const graph::Op op = GetParam();
    const auto arity = static_cast<std::size_t>(graph::facts(op).arity);
    Random random(seed);
    for (int checked = 0; checked < samples;) {
        Box box;
        for (Interval& side : box) side = random_interval(random);
        const Interval result = over(op, box);
        ASSERT_TRUE(result.is_empty() ? result == Interval::empty() : result.lo <= result.hi)
            << describe(op, box) << " gives [" << result.lo << ", " << result.hi << "]";
        for (int k = 0; k < samples_a_box; ++k) {
            Point p{};
            for (std::size_t n = 0; n < arity; ++n) p[n] = sample(box[n], random);
            if (is_excluded(op, p)) continue;
            ++checked;
            ASSERT_TRUE(is_covered(result, at(op, p)) && is_covered(result, exactly(op, p)))
                << describe(op, box) << " gives [" << result.lo << ", " << result.hi << "], but at "
                << ::testing::PrintToString(p) << " the value is " << at(op, p) << ", exactly "
                << static_cast<double>(exactly(op, p));
        }
    }
}

TEST_P(Operators, intervals_grow_with_their_arguments) {
    const graph::Op op = GetParam();
    Random random(seed + 1);
    for (int i = 0; i < boxes; ++i) {
        Box outer, inner;
        for (std::size_t n = 0; n < outer.size(); ++n) {
            outer[n] = random_interval(random);
            const double a = sample(outer[n], random), b = sample(outer[n], random);
            inner[n] = {std::min(a, b), std::max(a, b)};
        }
        const Interval large = over(op, outer), small = over(op, inner);
        if (small.is_empty() || is_excluded(op, inner)) continue;
        // The functions of the C library are monotone only up to their error.
        ASSERT_LE(numeric::steps_down(large.lo, 8), small.lo) << describe(op, outer);
        ASSERT_GE(numeric::steps_up(large.hi, 8), small.hi) << describe(op, outer);
        ASSERT_TRUE(large.partial || !small.partial) << describe(op, outer);
        ASSERT_TRUE(large.jumps || !small.jumps) << describe(op, outer);
    }
}

/// Between two points of a small box without flags the value changes little: that is what a missing
/// `jumps` promises.
TEST_P(Operators, values_do_not_jump_where_no_jump_is_reported) {
    const graph::Op op = GetParam();
    Random random(seed + 2);
    for (int i = 0; i < boxes; ++i) {
        Box box;
        for (Interval& side : box) {
            const double middle = random() % 4 == 0 ? 0 : ordinary_number(random);
            side = {middle - 1e-9, middle + 1e-9};
        }
        const Interval result = over(op, box);
        if (result.is_empty() || result.partial || result.jumps) continue;
        Point p, q;
        for (std::size_t n = 0; n < p.size(); ++n) {
            p[n] = sample(box[n], random);
            q[n] = sample(box[n], random);
        }
        if (is_excluded(op, p) || is_excluded(op, q)) continue;
        const double a = at(op, p), b = at(op, q);
        EXPECT_LE(std::abs(a - b), 1e-2 * std::max(1.0, std::abs(a))) << describe(op, box);
    }
}

std::vector<graph::Op> all_operators() {
    std::vector<graph::Op> list;
    graph::for_each_operator([&](graph::Op op) { list.push_back(op); });
    return list;
}

INSTANTIATE_TEST_SUITE_P(All, Operators, ::testing::ValuesIn(all_operators()),
                         [](const auto& info) {
                             return std::string(graph::facts(info.param).name);
                         });

TEST(Apply, takes_the_operators_arguments_in_their_order) {
    const std::array numbers{7.0, 2.0, 5.0, 11.0};
    const auto at = [&](graph::Op op, std::size_t count) {
        return apply<double>(op, std::span(numbers).first(count));
    };
    EXPECT_EQ(at(graph::Op::neg, 1), -7);
    EXPECT_EQ(at(graph::Op::sub, 2), 5);
    EXPECT_EQ(at(graph::Op::div, 2), 3.5);
    EXPECT_EQ(at(graph::Op::pow, 2), 49);
    EXPECT_EQ(at(graph::Op::select_less, 4), 11);
}

}  // namespace
}  // namespace eval
