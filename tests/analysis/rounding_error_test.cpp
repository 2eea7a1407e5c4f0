// SPDX-License-Identifier: MIT
// The bound of the rounding error: above every error that operators may make which keep their
// promises, and not absurdly far above. (The contract test holds it against a driver.)
#include "analysis/rounding_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <fmt/format.h>

#include "analysis/erring_value.h"
#include "analysis/formulas.h"
#include "eval/random_expression.h"
#include "graph/print.h"

namespace analysis {
namespace {

using numeric::Interval;

constexpr unsigned seed = 20261122;

double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
}

struct Tally {
    int bounded = 0;
    double closest = 0;  ///< the largest error found, in parts of its bound
};

void expect_within(const graph::Graph& graph, graph::NodeId root, const Rounded& bound,
                   double found, Tally& tally) {
    if (!std::isfinite(bound.error) || !std::isfinite(found)) return;
    ++tally.bounded;
    const double error = std::max(bound.exact.lo - found, found - bound.exact.hi);
    tally.closest = std::max(tally.closest, error / bound.error);
    EXPECT_LE(error, bound.error) << "seed " << seed << "\n"
                                  << graph::print(graph, std::array{root});
}

TEST(RoundingError, is_above_that_of_operators_that_err_as_much_as_they_may) {
    Random random(seed);
    Tally points, cells;
    int values = 0;
    for (int i = 0; i < 400; ++i) {
        const eval::RandomExpression e = eval::random_expression(random, 2 + i % 12, 4);
        const eval::Tape tape = eval::make_tape(e.graph, std::array{e.root});
        RoundingErrors errors(tape, {});
        for (int k = 0; k < 50; ++k) {
            std::vector<double> at(4);
            std::vector<Rounded> point(4), cell(4);
            for (std::size_t v = 0; v < 4; ++v) {
                at[v] = rounded(uniform(random, -4, 4));
                point[v].exact = at[v];
                cell[v].exact = Interval(at[v] - uniform(random, 0, 0.1), at[v] + 0.01);
            }
            const double found = erring_value(tape, at, random);
            ++values;
            expect_within(e.graph, e.root, errors(point)[0], found, points);
            // The error somewhere in a cell is that at the point.
            Rounded over = errors(cell)[0];
            over.exact = errors(point)[0].exact;
            expect_within(e.graph, e.root, over, found, cells);
        }
    }
    fmt::print("{} values: at points {} bounded, closest {:.3f}; over cells {}, closest {:.3f}\n",
               values, points.bounded, points.closest, cells.bounded, cells.closest);
    EXPECT_GT(points.bounded, values / 2);
    EXPECT_GT(cells.bounded, values / 3);
    EXPECT_GT(points.closest, 0.5);
}

TEST(RoundingError, counts_the_rounding_of_the_point) {
    const Formula f([](auto x, auto, auto) { return 3.0 * x; });
    const eval::Tape tape = tape_of(f);
    RoundingErrors errors(tape, {});
    const Cell at{{0.5, 0, 0}, {0.5, 0, 0}};
    const double own = errors(at, 0)[0].error;
    EXPECT_GT(own, 0);
    EXPECT_LT(own, 4e-7);
    EXPECT_NEAR(errors(at, 1e-4)[0].error, 3e-4 + own, 1e-9);
}

TEST(RoundingError, grows_where_large_numbers_cancel) {
    const Formula near(
        [](auto x, auto y, auto z) { return squared(x) + squared(y) + squared(z) - 1.0; });
    const Formula far(
        [](auto x, auto y, auto z) { return squared(x) + squared(y + 1e4) + squared(z) - 1e8; });
    const Region region{glm::dvec3(0), glm::dvec3(1), false};
    const double small = rounding_error_bound(tape_of(near), region, {});
    EXPECT_LT(small, 1e-5);
    EXPECT_GT(rounding_error_bound(tape_of(far), region, {}), 1e6 * small);
}

TEST(RoundingError, is_unbounded_at_the_edge_of_a_domain) {
    const Formula f([](auto x, auto, auto) { return log(x); });
    EXPECT_EQ(rounding_error_bound(tape_of(f), Region{}, {}), numeric::infinity);
    const Region inside{glm::dvec3(2), glm::dvec3(1), false};
    EXPECT_LT(rounding_error_bound(tape_of(f), inside, {}), 1e-5);
}

TEST(RoundingError, of_known_surfaces_is_not_absurdly_large) {
    Random random(seed + 1);
    const auto expect_close = [&](const char* name, auto build, double most) {
        const Formula f(build);
        const eval::Tape tape = tape_of(f);
        const double bound = rounding_error_bound(tape, Region{}, {});
        RoundingErrors exact(tape, {});
        double worst = 0;
        for (int k = 0; k < 4000; ++k) {
            std::vector<double> at(3);
            std::vector<Rounded> point(3);
            for (std::size_t v = 0; v < 3; ++v) {
                at[v] = rounded(uniform(random, -1.15, 1.15));
                point[v].exact = at[v];
            }
            const Interval value = exact(point)[0].exact;
            const double found = erring_value(tape, at, random);
            worst = std::max(worst, std::max(value.lo - found, found - value.hi));
        }
        fmt::print("{}: bound {:.3g}, worst found {:.3g}, ratio {:.1f}\n", name, bound, worst,
                   bound / worst);
        EXPECT_GE(bound, worst) << name;
        EXPECT_LE(bound, most * worst) << name;
    };
    expect_close("torus", torus, 20);
    expect_close("gyroid", gyroid, 20);
    expect_close("Barth sextic", barth_sextic, 60);
}

}  // namespace
}  // namespace analysis
