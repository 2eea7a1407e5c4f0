// SPDX-License-Identifier: MIT
// Derivatives of random expressions: jets against high-precision differences, against symbolic
// derivatives, and jets over intervals against jets at points.
#include <gtest/gtest.h>

#include <algorithm>

#include "eval/random_expression.h"
#include "eval/tape.h"
#include "eval/wide.h"
#include "graph/print.h"
#include "passes/differentiate.h"

namespace eval {
namespace {

using graph::NodeId;
using numeric::Interval;
using numeric::SecondOrder;
using numeric::triangle_place;

constexpr unsigned seed = 31415;

using Point = std::array<double, 3>;

/// A random expression and a place to look at.
struct Case {
    RandomExpression expression;
    Point point{};
    double parameter = 0;

    std::string describe() const {
        const std::array roots{expression.root};
        return ::testing::PrintToString(point) + ", p = " + std::to_string(parameter) + ", seed " +
               std::to_string(seed) + "\n" + graph::print(expression.graph, roots);
    }
};

Case random_case(Random& random, int size) {
    Case c{random_expression(random, size), {}, ordinary_number(random)};
    for (double& number : c.point) number = ordinary_number(random);
    return c;
}

/// The root with all derivatives, by the definition of the graph.
template <class T, int n>
SecondOrder<T, n> jet_at(const Case& c, const std::array<SecondOrder<T, n>, 3>& place) {
    using J = SecondOrder<T, n>;
    const std::array<J, 2> parameters{J(T(0.0)), J(T(c.parameter))};
    return values_by_type<J>(c.expression.graph, c.expression.root, place, parameters).back();
}

template <class T>
std::array<SecondOrder<T, 3>, 3> variables(const std::array<T, 3>& at) {
    return {SecondOrder<T, 3>::variable(at[0], 0), SecondOrder<T, 3>::variable(at[1], 1),
            SecondOrder<T, 3>::variable(at[2], 2)};
}

SecondOrder<Quad, 3> exact_jet(const Case& c) {
    return jet_at<Quad, 3>(c, variables<Quad>({c.point[0], c.point[1], c.point[2]}));
}

/// The root by the tape.
template <class J>
J by_tape(const Case& c, const std::array<J, 3>& place) {
    using T = typename J::Number;
    const std::array parameters{J(T(0.0)), J(T(c.parameter))};
    J result;
    std::vector<J> scratch;
    evaluate<J>(make_tape(c.expression.graph, std::array{c.expression.root}), place, parameters,
                std::span<J>(&result, 1), scratch);
    return result;
}

/// First and second derivative along the ray at its start, from the slopes of the jet.
template <class T>
std::array<T, 2> along(const SecondOrder<T, 3>& jet, const Point& d) {
    T first = 0.0, second = 0.0;
    for (int i = 0; i < 3; ++i) {
        const auto a = static_cast<std::size_t>(i);
        first = first + jet.slope(i) * T(d[a]);
        for (int j = i; j < 3; ++j) {
            const T times = T(i == j ? d[a] : 2 * d[a]) * T(d[static_cast<std::size_t>(j)]);
            second = second + jet.bend(triangle_place(i, j, 3)) * times;
        }
    }
    return {first, second};
}

/// The same from values at five places, of the fourth order in their distance.
std::array<Quad, 2> differences(const Case& c, const Point& d) {
    constexpr double h = 0x1p-22;
    std::array<Quad, 5> f;
    for (int k = -2; k <= 2; ++k) {
        std::array<Quad, 3> at;
        for (std::size_t i = 0; i < 3; ++i) at[i] = Quad(c.point[i]) + Quad(k * h) * Quad(d[i]);
        const std::array<Quad, 2> parameters{Quad(0.0), Quad(c.parameter)};
        f[static_cast<std::size_t>(k + 2)] =
            values_by_type<Quad>(c.expression.graph, c.expression.root, at, parameters).back();
    }
    const Quad first = (8.0 * (f[3] - f[1]) - (f[4] - f[0])) / Quad(12 * h);
    const Quad second = (16.0 * (f[3] + f[1]) - (f[4] + f[0]) - 30.0 * f[2]) / Quad(12 * h * h);
    return {first, second};
}

Point random_direction(Random& random) {
    Point d;
    std::uniform_real_distribution<double> number(0.25, 1);
    for (double& component : d) component = random() % 2 == 0 ? number(random) : -number(random);
    return d;
}

bool near(const Quad& a, const Quad& b, double relative, double absolute) {
    return abs(a - b).number <= absolute + relative * max(abs(a), abs(b)).number;
}

/// True where derivatives are not so large that differences say nothing.
bool is_tame(const SecondOrder<Quad, 3>& jet) {
    const auto small = [](const Quad& a) { return abs(a).number < 1e4; };
    return jet.smooth && small(jet.value) && std::ranges::all_of(jet.gradient, small) &&
           std::ranges::all_of(jet.hessian, small);
}

TEST(Jets, agree_with_high_precision_differences) {
    Random random(seed);
    int checked = 0;
    for (int i = 0; i < 6000; ++i) {
        const Case c = random_case(random, 10);
        const SecondOrder<Quad, 3> jet = exact_jet(c);
        if (!is_tame(jet)) continue;
        ++checked;
        const Point d = random_direction(random);
        const std::array<Quad, 2> expected = differences(c, d), found = along(jet, d);
        EXPECT_TRUE(near(found[0], expected[0], 1e-9, 1e-9))
            << double(found[0]) << " instead of " << double(expected[0]) << " at " << c.describe();
        EXPECT_TRUE(near(found[1], expected[1], 1e-8, 1e-8))
            << double(found[1]) << " instead of " << double(expected[1]) << " at " << c.describe();
    }
    EXPECT_GT(checked, 2000);
}

TEST(Jets, agree_with_symbolic_derivatives) {
    Random random(seed + 1);
    int checked = 0;
    for (int i = 0; i < 3000; ++i) {
        Case c = random_case(random, 10);
        const SecondOrder<Quad, 3> jet = exact_jet(c);
        if (!jet.smooth) continue;
        ++checked;
        const std::array<Quad, 3> at{c.point[0], c.point[1], c.point[2]};
        const std::array<Quad, 2> parameters{Quad(0.0), Quad(c.parameter)};
        graph::Graph& g = c.expression.graph;
        const auto compare = [&](NodeId symbolic, const Quad& found) {
            const Quad expected = values_by_type<Quad>(g, symbolic, at, parameters).back();
            EXPECT_TRUE(near(found, expected, 1e-18, 1e-18))
                << double(found) << " instead of " << double(expected) << " at " << c.describe();
        };
        constexpr std::array by{graph::variable_x, graph::variable_y, graph::variable_z};
        for (int a = 0; a < 3; ++a) {
            const NodeId first =
                passes::differentiate(g, c.expression.root, by[static_cast<std::size_t>(a)]);
            compare(first, jet.slope(a));
            for (int b = a; b < 3; ++b) {
                compare(passes::differentiate(g, first, by[static_cast<std::size_t>(b)]),
                        jet.bend(triangle_place(a, b, 3)));
            }
        }
    }
    EXPECT_GT(checked, 1000);
}

TEST(Jets, along_a_ray_are_the_derivatives_along_it) {
    Random random(seed + 2);
    for (int i = 0; i < 2000; ++i) {
        const Case c = random_case(random, 10);
        const Point d = random_direction(random);
        std::array<SecondOrder<Quad, 1>, 3> ray;
        for (std::size_t k = 0; k < 3; ++k) {
            ray[k] = SecondOrder<Quad, 1>::along(c.point[k], d[k]);
        }
        const SecondOrder<Quad, 3> in_space = exact_jet(c);
        const SecondOrder<Quad, 1> on_ray = jet_at<Quad, 1>(c, ray);
        if (!in_space.smooth) continue;
        const std::array<Quad, 2> expected = along(in_space, d);
        EXPECT_TRUE(near(on_ray.gradient[0], expected[0], 1e-18, 1e-18)) << c.describe();
        EXPECT_TRUE(near(on_ray.hessian[0], expected[1], 1e-18, 1e-18)) << c.describe();
    }
}

/// Counts how often `check` is called for a derivative of each kind: value, gradient, Hessian.
template <class Check>
void for_each_part(const SecondOrder<Interval, 3>& over, Check check) {
    check(over.value, [](const auto& jet) { return jet.value; });
    for (std::size_t i = 0; i < 3; ++i) {
        check(over.gradient[i], [i](const auto& jet) { return jet.gradient[i]; });
    }
    for (std::size_t i = 0; i < 6; ++i) {
        check(over.hessian[i], [i](const auto& jet) { return jet.hessian[i]; });
    }
}

bool holds(const Interval& interval, double value) {
    return interval.contains(value) || (!std::isfinite(value) && interval.partial);
}
bool holds(const Interval& interval, const Quad& value) {
    const bool contains = interval.lo <= value.number && value.number <= interval.hi;
    return contains || (!is_regular(value) && interval.partial);
}

TEST(Jets, over_a_single_point_enclose_the_exact_derivatives_and_the_rounded_ones) {
    Random random(seed + 3);
    int checked = 0;
    for (int i = 0; i < 10000; ++i) {
        const Case c = random_case(random, 10);
        std::array<Interval, 3> box;
        for (std::size_t k = 0; k < 3; ++k) box[k] = c.point[k];
        const auto over = by_tape(c, variables<Interval>(box));
        const auto rounded = by_tape(c, variables<double>(c.point));
        const auto exact = exact_jet(c);
        if (!over.smooth) continue;  // where rounding decides on which side of a kink it is
        ++checked;
        for_each_part(over, [&](const Interval& enclosure, auto part) {
            ASSERT_TRUE(holds(enclosure, part(exact)) && holds(enclosure, part(rounded)))
                << "[" << enclosure.lo << ", " << enclosure.hi << "] holds not both "
                << double(part(exact)) << " and " << part(rounded) << " at " << c.describe();
        });
    }
    EXPECT_GT(checked, 4000);
}

TEST(Jets, over_a_box_enclose_those_at_its_points_and_know_where_all_are_smooth) {
    Random random(seed + 4);
    int smooth = 0, checked = 0;
    for (int i = 0; i < 6000; ++i) {
        Case c = random_case(random, 7);
        std::array<Interval, 3> box;
        for (Interval& side : box) {
            const double low = ordinary_number(random);
            side = {low, low + 0.5 * static_cast<double>(random() % 3)};
        }
        const auto over = by_tape(c, variables<Interval>(box));
        smooth += over.smooth;
        for (int k = 0; k < 20; ++k) {
            for (std::size_t n = 0; n < 3; ++n) {
                c.point[n] = random() % 4 == 0 ? box[n].lo
                                               : std::uniform_real_distribution<double>(
                                                     box[n].lo, box[n].hi)(random);
            }
            const auto at = by_tape(c, variables<double>(c.point));
            // A proof for the box is more than a judgement at a point.
            if (!at.smooth && !over.smooth) continue;
            ++checked;
            for_each_part(over, [&](const Interval& enclosure, auto part) {
                ASSERT_TRUE(holds(enclosure, part(at)))
                    << "[" << enclosure.lo << ", " << enclosure.hi << "] does not hold " << part(at)
                    << " at " << c.describe();
            });
        }
    }
    EXPECT_GT(smooth, 1500);
    EXPECT_GT(checked, 40000);
}

}  // namespace
}  // namespace eval
