// SPDX-License-Identifier: MIT
// Whole formulas on the GPU against a running error bound: random ones, and well-known surfaces.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "analysis/formulas.h"
#include "analysis/rounding_error.h"
#include "contract/arguments.h"
#include "contract/glsl_values.h"
#include "contract/running_error.h"
#include "eval/random_expression.h"
#include "graph/print.h"
#include "headless.h"
#include "passes/pipeline.h"

namespace contract {
namespace {

using numeric::Interval;

constexpr unsigned seed = 20261122;
constexpr std::size_t places_a_formula = 1024;

/// How much the bounds said.
struct Tally {
    int values = 0;     ///< compared
    int decided = 0;    ///< with a bound that leaves neither NaN nor infinity open
    int undefined = 0;  ///< that must be NaN
    int sharp = 0;      ///< with a bound of at most a thousandth of the value
    int bounded = 0;    ///< with a finite bound of the rounding error

    void count(const Interval& bound) {
        ++values;
        undefined += bound.is_empty();
        if (bound.is_empty() || bound.partial) return;
        ++decided;
        sharp += bound.hi - bound.lo <= 1e-3 * (1 + magnitude(bound));
    }
};

bool agrees(const Interval& bound, float found) {
    if (bound.is_empty()) return std::isnan(found);
    if (!std::isfinite(found) && bound.partial) return true;
    return bound.contains(found);
}

std::vector<Arguments> random_places(std::size_t count, Random& random) {
    constexpr Range range{-4, 4};
    std::vector<Arguments> list(count);
    for (Arguments& place : list) {
        for (float& number : place) number = random_number(range, random);
    }
    return list;
}

/// The value of a formula at a point with the bound of its rounding error.
analysis::Rounded rounded_value(analysis::RoundingErrors& errors, const Arguments& place) {
    std::array<analysis::Rounded, graph::max_arity> variables;
    for (std::size_t i = 0; i < variables.size(); ++i) {
        variables[i].exact = static_cast<double>(place[i]);
    }
    return errors(variables)[0];
}

bool is_within(const analysis::Rounded& bound, float found) {
    return bound.exact.is_empty() || !std::isfinite(bound.error) ||
           (found >= bound.exact.lo - bound.error && found <= bound.exact.hi + bound.error);
}

/// Draws up to four formulas of a graph and compares them at random places.
void compare(const render::Context& context, const graph::Graph& graph,
             std::span<const graph::NodeId> roots, Random& random, Tally& tally) {
    const auto program = expression_program(graph, roots);
    if (!program) return;
    const std::vector<Arguments> places = random_places(places_a_formula, random);
    const auto found = glsl_values(context, *program, places);
    ASSERT_EQ(found.size(), places.size());
    int wrong = 0;
    for (std::size_t k = 0; k < roots.size(); ++k) {
        const eval::Tape tape = eval::make_tape(graph, std::array{roots[k]});
        analysis::RoundingErrors errors(tape, {});
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Interval bound = gpu_enclosure(graph, roots[k], places[i]);
            tally.count(bound);
            const analysis::Rounded rounded = rounded_value(errors, places[i]);
            tally.bounded += std::isfinite(rounded.error);
            EXPECT_TRUE(is_within(rounded, found[i][k]) || ++wrong > 3) << fmt::format(
                "{:.9g} in GLSL is farther from [{:.17g}, {:.17g}] than {:.3g}, seed {}\n{}",
                found[i][k], rounded.exact.lo, rounded.exact.hi, rounded.error, seed,
                graph::print(graph, std::array{roots[k]}));
            if (agrees(bound, found[i][k]) || ++wrong > 3) continue;
            ADD_FAILURE() << fmt::format(
                "{:.9g} in GLSL is not in [{:.9g}, {:.9g}]{} at {:.9g}, {:.9g}, {:.9g}, {:.9g}, "
                "seed {}\n{}",
                found[i][k], bound.lo, bound.hi, bound.partial ? " (partial)" : "", places[i][0],
                places[i][1], places[i][2], places[i][3], seed,
                graph::print(graph, std::array{roots[k]}));
        }
    }
}

void print_tally(const char* name, const Tally& tally) {
    fmt::print(
        "{}: {} values, {} decided, {} of them within a thousandth, {} undefined, {} with a bound "
        "of the error\n",
        name, tally.values, tally.decided, tally.sharp, tally.undefined, tally.bounded);
}

class Formulas : public testing::Test {
protected:
    void SetUp() override {
        auto opened = open_headless();
        ASSERT_TRUE(opened) << opened.problems()[0].message;
        context = std::move(*opened);
    }

    std::unique_ptr<render::Context> context;
};

TEST_F(Formulas, random_ones_are_within_their_running_error_bounds) {
    Random random(seed);
    Tally tally;
    for (int i = 0; i < 30; ++i) {
        // Four expressions share a graph: the last nodes of one that grew.
        eval::RandomExpression e = eval::random_expression(random, 4 + i % 12, 4);
        std::vector<graph::NodeId> roots;
        for (std::size_t k = 1; k <= 4 && k < e.graph.size(); ++k) {
            roots.push_back(static_cast<graph::NodeId>(e.graph.size() - k));
        }
        compare(*context, e.graph, passes::run(e.graph, roots), random, tally);
    }
    print_tally("random formulas", tally);
    EXPECT_GT(tally.values, 80'000);
    EXPECT_GT(tally.decided, tally.values / 3);
    EXPECT_GT(tally.sharp, tally.decided / 2);
    EXPECT_GT(tally.undefined, tally.values / 100);
    EXPECT_GT(tally.bounded, tally.values / 3);
}

TEST_F(Formulas, of_known_surfaces_are_within_their_running_error_bounds) {
    Random random(seed + 1);
    Tally tally;
    const auto surface = [&](auto build) {
        const analysis::Formula f(build);
        compare(*context, f.graph, std::array{f.value}, random, tally);
    };
    surface(analysis::barth_sextic);
    surface(analysis::gyroid);
    surface(analysis::torus);
    surface([](graph::Expr x, graph::Expr y, graph::Expr z) {
        return hypot(x, y, z) - 1.0 + 0.1 * sin(8.0 * x) * exp(-y * y) * log(abs(z));
    });
    print_tally("known surfaces", tally);
    EXPECT_EQ(tally.values, 4 * static_cast<int>(places_a_formula));
    EXPECT_GT(tally.sharp, tally.values * 9 / 10);
    EXPECT_GT(tally.bounded, tally.values * 9 / 10);
}

}  // namespace
}  // namespace contract
