// SPDX-License-Identifier: MIT
// Bounds of derivatives brick by brick, held against symbolic derivatives at points.
#include "analysis/leaf_bricks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include "analysis/counted_budget.h"
#include "analysis/formulas.h"
#include "analysis/spectral_norm.h"
#include "analysis/symbolic_derivatives.h"
#include "eval/random_expression.h"

namespace analysis {
namespace {

constexpr Region ball{};  // of radius 2

struct Sheet {
    field::Field field;
    eval::Tape tape;

    Sheet(graph::Graph graph, graph::NodeId f) {
        field.graph = std::move(graph);
        field.root = field.add(field::Formula{f, field::Metric::scalar, field::Kind::sheet});
        tape = eval::make_tape(field.graph, std::array{f});
    }
    explicit Sheet(const Formula& f) : Sheet(f.graph, f.value) {}

    LeafBricks known(std::span<const double> parameters = {},
                     const BrickEffort& effort = {}) const {
        return leaf_bricks(field, field.root, tape, parameters, ball, effort);
    }
};

/// How many bounds are finite; none is below what is found at points.
struct Finite {
    int first = 0, second = 0;
};
Finite expect_bounds_hold(const LeafBricks& known, const eval::Tape& derivatives,
                          std::span<const double> parameters) {
    Finite finite;
    std::vector<double> registers, v(derivatives.roots.size());
    eval::load_parameters<double>(derivatives, parameters, registers);
    const BrickGrid& grid = known.bricks.grid;
    for (std::size_t i = 0; i < known.bounds.size(); ++i) {
        if (known.bricks.bricks[i] != Brick::surface) continue;
        const BrickBounds& bounds = known.bounds[i];
        finite.first += bounds.lipschitz < numeric::infinity;
        finite.second += bounds.second_derivative < numeric::infinity;
        const Cell cell = grid.widened(grid.at(i));
        for (unsigned k = 0; k < 4; ++k) {
            const glm::dvec3 p =
                spread_point({cell.middle(), 0.5 * (cell.high - cell.low), false}, k);
            if (!contains(ball, p)) continue;
            eval::evaluate_loaded<double>(derivatives, std::array{p.x, p.y, p.z}, v, registers);
            if (!std::ranges::all_of(v, [](double x) { return std::isfinite(x); })) continue;
            const Symmetric<double> h{v[4], v[5], v[6], v[7], v[8], v[9]};
            const glm::dvec3 d = glm::normalize(spread_point(ball, k * 7 + 3));
            const double along = h.xx * d.x * d.x + h.yy * d.y * d.y + h.zz * d.z * d.z +
                                 2 * (h.xy * d.x * d.y + h.xz * d.x * d.z + h.yz * d.y * d.z);
            EXPECT_GE(bounds.lipschitz * (1 + 1e-9), numeric::hypot3(v[1], v[2], v[3])) << i;
            EXPECT_GE(bounds.second_derivative * (1 + 1e-9), std::abs(along)) << i;
        }
    }
    return finite;
}

TEST(LeafBricks, bound_derivatives_of_random_expressions) {
    constexpr unsigned seed = 141421;
    eval::Random random(seed);
    Finite finite;
    for (int i = 0; i < 200; ++i) {
        const eval::RandomExpression e = eval::random_expression(random, 6);
        const std::array parameters{0.0, eval::ordinary_number(random)};
        const Sheet sheet(e.graph, e.root);
        SCOPED_TRACE("expression " + std::to_string(i) + ", seed " + std::to_string(seed));
        const Finite of_this =
            expect_bounds_hold(sheet.known(parameters, {.side = 8}),
                               symbolic_derivatives(e.graph, e.root), parameters);
        finite.first += of_this.first > 0;
        finite.second += of_this.second > 0;
    }
    EXPECT_GT(finite.first, 50);
    EXPECT_GT(finite.second, 25);
}

TEST(LeafBricks, are_far_below_the_bound_of_the_region_near_the_surface) {
    // Of degree 6: the second derivative grows by the fourth power of the distance.
    const Formula f([](graph::Expr x, graph::Expr y, graph::Expr z) {
        const graph::Expr s = squared(x) + squared(y) + squared(z);
        return s * s * s - 1.0;
    });
    const LeafBricks known = Sheet(f).known();
    expect_bounds_hold(known, symbolic_derivatives(f.graph, f.value), {});
    for (std::size_t i = 0; i < known.bounds.size(); ++i) {
        if (known.bricks.bricks[i] != Brick::surface) continue;
        EXPECT_TRUE(known.bounds[i].certified());
        // 30 on the unit sphere, 480 on that of the region.
        EXPECT_LT(known.bounds[i].second_derivative, 160);
    }
}

TEST(LeafBricks, lose_their_certificate_at_a_pole_only) {
    const Formula f([](graph::Expr x, graph::Expr y, graph::Expr) { return y - 1.0 / (x - 0.1); });
    const LeafBricks known = Sheet(f).known();
    const BrickGrid& grid = known.bricks.grid;
    int certified = 0;
    for (std::size_t i = 0; i < known.bounds.size(); ++i) {
        if (known.bricks.bricks[i] != Brick::surface) continue;
        const Cell cell = grid.widened(grid.at(i));
        const bool pole = cell.low.x <= 0.1 && 0.1 <= cell.high.x;
        EXPECT_EQ(known.bounds[i].breaks, pole) << i;
        certified += known.bounds[i].certified();
    }
    EXPECT_GT(certified, 100);
}

TEST(LeafBricks, are_stiff_where_only_the_largest_values_allow_a_step) {
    const Formula f([](graph::Expr x, graph::Expr y, graph::Expr z) {
        const graph::Expr twenty(*x.graph, 20.0);
        return pow(x, twenty) + pow(y, twenty) + pow(z, twenty) - 1.0;
    });
    const Sheet sheet(f);
    const LeafBricks known = leaf_bricks(sheet.field, sheet.field.root, sheet.tape, {},
                                         {{0, 0, 0}, {40, 40, 40}, false}, {});
    int surfaces = 0;
    for (std::size_t i = 0; i < known.bounds.size(); ++i) {
        if (known.bricks.bricks[i] != Brick::surface) continue;
        ++surfaces;
        EXPECT_FALSE(known.bounds[i].breaks);
        EXPECT_TRUE(known.bounds[i].stiff);
    }
    EXPECT_EQ(surfaces, 8);
}

TEST(LeafBricks, decide_more_than_values_alone) {
    // Expanded, so that intervals of the value are wide.
    const Formula f([](graph::Expr x, graph::Expr y, graph::Expr z) {
        return squared(x) + squared(y) + squared(z) - 2.0 * x * y * z - 1.0;
    });
    const Sheet sheet(f);
    const Bricks by_values = bricks(sheet.field, sheet.field.root, {}, ball, {.side = 16});
    const LeafBricks known = sheet.known();
    EXPECT_GT(known.bricks.decided(), by_values.decided());
    // And rightly so.
    for (std::size_t i = 0; i < known.bounds.size(); ++i) {
        if (known.bricks.bricks[i] == Brick::surface) continue;
        const Cell cell = known.bricks.grid.widened(known.bricks.grid.at(i));
        int positive = 0, inside = 0;
        for (unsigned k = 0; k < 8; ++k) {
            const glm::dvec3 p =
                spread_point({cell.middle(), 0.5 * (cell.high - cell.low), false}, k);
            if (!contains(ball, p)) continue;
            ++inside;
            positive += eval::evaluate(f.graph, f.value, p) > 0;
        }
        EXPECT_TRUE(positive == 0 || positive == inside) << i;
    }
}

TEST(LeafBricks, are_larger_where_jets_cost_too_much) {
    const Sheet sheet{Formula(barth_sextic)};
    const LeafBricks few = sheet.known({}, {.jet_operations = 20'000});
    EXPECT_LT(few.bricks.grid.side, sheet.known().bricks.grid.side);
    const Formula f(barth_sextic);
    expect_bounds_hold(few, symbolic_derivatives(f.graph, f.value), {});
}

TEST(LeafBricks, are_the_same_on_any_number_of_threads) {
    const Sheet sheet{Formula(barth_sextic)};
    const LeafBricks one = sheet.known();
    for (const int threads : {2, 5}) {
        const LeafBricks other = sheet.known({}, {.threads = threads});
        EXPECT_EQ(one.bricks.bricks, other.bricks.bricks);
        ASSERT_EQ(one.bounds.size(), other.bounds.size());
        for (std::size_t i = 0; i < one.bounds.size(); ++i) {
            EXPECT_EQ(one.bounds[i].lipschitz, other.bounds[i].lipschitz);
            EXPECT_EQ(one.bounds[i].second_derivative, other.bounds[i].second_derivative);
        }
    }
}

TEST(LeafBricks, are_bounded_by_larger_cells_when_time_runs_out) {
    const Formula f(barth_sextic);
    const Sheet sheet(f);
    const eval::Tape derivatives = symbolic_derivatives(f.graph, f.value);
    const LeafBricks fine = sheet.known();
    double certified = -1;
    for (const int questions : {0, 1, 10, 100, 500, 1000, 2000, 1'000'000}) {
        const Budget budget = over_after(questions);
        const LeafBricks some = sheet.known({}, {.threads = 2, .budget = &budget});
        SCOPED_TRACE(std::to_string(questions) + " questions");
        EXPECT_EQ(budget.was_over(), questions < 1'000'000);
        const Finite finite = expect_bounds_hold(some, derivatives, {});
        EXPECT_EQ(finite.first, finite.second);
        EXPECT_EQ(finite.first, some.bricks.bricks.size() - some.bricks.decided());
        const BrickGrid& grid = fine.bricks.grid;
        const int ratio = grid.side / some.bricks.grid.side;
        double part = 0;
        for (std::size_t i = 0; i < grid.count(); ++i) {
            const std::size_t large = some.bricks.grid.place(grid.at(i) / ratio);
            const bool open = some.bricks.bricks[large] == Brick::surface;
            part += !open || some.bounds[large].certified();
            if (fine.bricks.bricks[i] != Brick::surface) continue;
            ASSERT_TRUE(open) << i;
            EXPECT_GE(some.bounds[large].lipschitz, fine.bounds[i].lipschitz) << i;
            EXPECT_GE(some.bounds[large].second_derivative * (1 + 1e-9),
                      fine.bounds[i].second_derivative)
                << i;
        }
        // More time is worth something.
        EXPECT_GE(part, certified);
        certified = part;
    }
    const Budget enough = over_after(1'000'000);
    EXPECT_EQ(sheet.known({}, {.budget = &enough}).bricks.bricks, fine.bricks.bricks);
}

}  // namespace
}  // namespace analysis
