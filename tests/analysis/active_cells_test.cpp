// SPDX-License-Identifier: MIT
// Operands that can matter in a cell, and cells that are far, against all operands at many points.
#include "analysis/active_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <glm/glm.hpp>

#include "analysis/counted_budget.h"
#include "graph/build.h"

namespace analysis {
namespace {

using graph::Expr;

/// Balls of the first kind, boxes of the second, here and there.
struct Scene {
    graph::Graph graph{};
    std::vector<graph::VariableId> variables{};
    std::array<eval::Tape, 2> tapes{};
    Operands operands{};

    Scene(std::mt19937& random, int count, double spread) {
        const auto point = [&](graph::VariableId id) { return Expr(graph, graph.variable(id)); };
        for (const char* name : {"a", "b", "c", "d"}) {
            variables.push_back(graph.new_variable(name));
        }
        const std::array moved{point(graph::variable_x) - point(variables[0]),
                               point(graph::variable_y) - point(variables[1]),
                               point(graph::variable_z) - point(variables[2])};
        const Expr size = point(variables[3]);
        const Expr ball = hypot(moved[0], moved[1], moved[2]) - size;
        const Expr box = max(max(abs(moved[0]), abs(moved[1])), abs(moved[2])) - size;
        tapes = {eval::make_tape(graph, std::array{ball.id}),
                 eval::make_tape(graph, std::array{box.id})};
        for (const eval::Tape& tape : tapes) {
            operands.kinds.push_back({&tape, variables, {{}, {}, {}, {}}});
        }
        std::uniform_real_distribution<double> place(-spread, spread), radius(0.01, 0.1);
        for (int i = 0; i < count; ++i) {
            const std::size_t kind = random() % 3 == 0 ? 1 : 0;
            auto& numbers = operands.kinds[kind].numbers;
            operands.kind.push_back(static_cast<std::uint32_t>(kind));
            operands.place.push_back(static_cast<std::uint32_t>(numbers[0].size()));
            for (int k = 0; k < 3; ++k)
                numbers[static_cast<std::size_t>(k)].push_back(place(random));
            numbers[3].push_back(radius(random));
        }
    }

    double value(std::uint32_t operand, const glm::dvec3& p) const {
        const auto& numbers = operands.kinds[operands.kind[operand]].numbers;
        const std::size_t i = operands.place[operand];
        const glm::dvec3 d = p - glm::dvec3(numbers[0][i], numbers[1][i], numbers[2][i]);
        if (operands.kind[operand] == 0) return std::sqrt(glm::dot(d, d)) - numbers[3][i];
        return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) - numbers[3][i];
    }
    template <class List>
    double minimum(const List& list, const glm::dvec3& p, std::optional<double> width) const {
        double least = 1e30;
        for (const std::uint32_t operand : list) {
            const double f = value(operand, p);
            const double overlap = width ? std::max(1 - std::abs(least - f) / *width, 0.0) : 0;
            least = std::min(least, f) - overlap * overlap * width.value_or(0) / 4;
        }
        return least;
    }
};

std::vector<std::uint32_t> all_of(const Scene& scene) {
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < scene.operands.kind.size(); ++i) all.push_back(i);
    return all;
}

using Kind = ActiveCells::Cell::Kind;

ActiveCells cells_of(const Scene& scene, const Region& region, std::optional<double> width,
                     bool may_be_far) {
    return active_cells(
        {.minima = {{scene.operands, width}}, .may_be_far = may_be_far, .inside_too = may_be_far},
        region);
}

TEST(ActiveCells, have_the_minimum_of_all_operands_at_every_point) {
    const std::uint32_t seed = 20261122;
    std::mt19937 random(seed);
    for (int round = 0; round < 12; ++round) {
        const int count = 20 + 60 * round;
        const Scene scene(random, count, round % 2 == 0 ? 1 : 0.4);
        const std::optional<double> width =
            round % 3 == 0 ? std::nullopt : std::optional(round % 3 == 1 ? 0.02 : 0.3);
        const Region region{{0.1, -0.2, 0}, {0.9, 1.2, 0.7}, false};
        const Cell box = bounding_cell(region);
        const ActiveCells cells = cells_of(scene, region, width, round % 4 < 2);
        const std::vector<std::uint32_t> all = all_of(scene);
        std::uniform_real_distribution<double> unit(0, 1);
        int far = 0;
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 part(unit(random), unit(random), unit(random));
            const glm::dvec3 p = glm::mix(box.low, box.high, part);
            const double expected = scene.minimum(all, p, width);
            const ActiveCells::Place place = cells.at(p);
            const ActiveCells::Cell& cell = cells.cells[place.cell];
            if (cell.kind == Kind::far) {
                ++far;
                const double bound = std::abs(cell.value) - glm::distance(p, place.middle);
                ASSERT_GT(bound, 0) << "seed " << seed << ", round " << round << ", point " << i;
                ASSERT_LE(bound, std::abs(expected)) << "seed " << seed << ", round " << round;
                ASSERT_EQ(cell.value < 0, expected < 0) << "seed " << seed << ", round " << round;
                const double told = cell.value + glm::dot(cell.gradient, p - place.middle);
                ASSERT_NEAR(told / expected, 1, 0.2) << "seed " << seed << ", round " << round;
                continue;
            }
            ASSERT_EQ(cell.kind, Kind::listed);
            ASSERT_NEAR(scene.minimum(cells.of(cell.place), p, width), expected,
                        1e-12 + 3e-8 * width.value_or(0))
                << "seed " << seed << ", round " << round << ", point " << i;
        }
        if (round % 4 < 2) {
            EXPECT_GT(far, 100) << round;
        } else {
            EXPECT_EQ(far, 0) << round;
        }
    }
}

/// Of the points, how many are in far cells; else the mean length of lists.
struct Survey {
    double far = 0, length = 0;
};

Survey survey(const ActiveCells& cells, std::mt19937& random) {
    std::uniform_real_distribution<double> place(-1, 1);
    Survey result;
    constexpr int points = 10'000;
    for (int i = 0; i < points; ++i) {
        const ActiveCells::Place at = cells.at({place(random), place(random), place(random)});
        const ActiveCells::Cell& cell = cells.cells[at.cell];
        if (cell.kind == Kind::far) result.far += 1;
        if (cell.kind == Kind::listed) {
            result.length += static_cast<double>(cells.of(cell.place).size());
        }
    }
    result.length /= points - result.far;
    result.far /= points;
    return result;
}

TEST(ActiveCells, hold_few_of_many_operands) {
    std::mt19937 random(7);
    const Scene scene(random, 1000, 1);
    const Region box{glm::dvec3(0), glm::dvec3(1), false};
    const Survey plain = survey(cells_of(scene, box, std::nullopt, false), random);
    const Survey smooth = survey(cells_of(scene, box, 0.05, false), random);
    EXPECT_LT(plain.length, 6);
    EXPECT_LT(smooth.length, 40);
    EXPECT_GT(plain.length, 1);
}

TEST(ActiveCells, are_far_if_they_may_be) {
    std::mt19937 random(8);
    const Scene scene(random, 500, 0.3);
    const Region box{glm::dvec3(0), glm::dvec3(1), false};
    EXPECT_GT(survey(cells_of(scene, box, std::nullopt, true), random).far, 0.5);
    EXPECT_EQ(survey(cells_of(scene, box, std::nullopt, false), random).far, 0);
}

TEST(ActiveCells, follow_the_outline_of_a_formula) {
    // A ball from which many balls and boxes are cut.
    std::mt19937 random(12);
    Scene scene(random, 200, 0.8);
    graph::Graph& graph = scene.graph;
    const auto variable = [&](graph::VariableId id) { return Expr(graph, graph.variable(id)); };
    const graph::VariableId cut = graph.new_variable("cut");
    const Expr x = variable(graph::variable_x), y = variable(graph::variable_y),
               z = variable(graph::variable_z);
    const Expr value = max(hypot(x, y, z) - Expr(graph, 0.7), -variable(cut));
    const eval::Tape outline = eval::make_tape(graph, std::array{value.id});
    const Region region{glm::dvec3(0), glm::dvec3(1), true};
    const ActiveCells cells = active_cells({.minima = {{scene.operands, std::nullopt, cut}},
                                            .outline = &outline,
                                            .may_be_far = true,
                                            .inside_too = true},
                                           region);
    const std::vector<std::uint32_t> all = all_of(scene);
    std::uniform_real_distribution<double> place(-0.57, 0.57);
    int far = 0;
    for (int i = 0; i < 4000; ++i) {
        const glm::dvec3 p(place(random), place(random), place(random));
        const double hole = scene.minimum(all, p, std::nullopt);
        const double expected = std::max(glm::length(p) - 0.7, -hole);
        const ActiveCells::Place at = cells.at(p);
        const ActiveCells::Cell& cell = cells.cells[at.cell];
        if (cell.kind == Kind::far) {
            ++far;
            ASSERT_LE(std::abs(cell.value) - glm::distance(p, at.middle), std::abs(expected)) << i;
            ASSERT_EQ(cell.value < 0, expected < 0) << i;
        } else {
            ASSERT_EQ(cell.kind, Kind::listed) << i;
            ASSERT_NEAR(scene.minimum(cells.of(cell.place), p, std::nullopt), hole, 1e-12) << i;
        }
    }
    EXPECT_GT(far, 500);
    EXPECT_LT(far, 3500);
}

TEST(ActiveCells, have_no_lists_outside_of_a_ball_and_only_there) {
    std::mt19937 random(9);
    const Scene scene(random, 100, 1);
    const Region ball{glm::dvec3(0.5), glm::dvec3(1), true};
    const ActiveCells cells = cells_of(scene, ball, std::nullopt, false);
    const Cell box = bounding_cell(ball);
    std::uniform_real_distribution<double> unit(0, 1);
    int outside = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 part(unit(random), unit(random), unit(random));
        const glm::dvec3 p = glm::mix(box.low, box.high, part);
        if (cells.cells[cells.at(p).cell].kind != Kind::everything) continue;
        ++outside;
        EXPECT_GT(glm::distance(p, ball.centre), 1) << i;
    }
    EXPECT_GT(outside, 400);
}

TEST(ActiveCells, are_in_order_and_the_same_each_time) {
    std::mt19937 random(3);
    const Scene scene(random, 300, 1);
    const Region box{glm::dvec3(0), glm::dvec3(1), false};
    const ActiveCells cells = cells_of(scene, box, 0.1, true),
                      again = cells_of(scene, box, 0.1, true);
    for (std::size_t i = 0; i + 1 < cells.begins.size(); ++i) {
        EXPECT_TRUE(std::ranges::is_sorted(cells.of(i))) << i;
    }
    const auto same = [](const ActiveCells::Cell& a, const ActiveCells::Cell& b) {
        return a.kind == b.kind && a.place == b.place && a.value == b.value;
    };
    EXPECT_TRUE(std::ranges::equal(cells.cells, again.cells, same));
    EXPECT_EQ(cells.begins, again.begins);
    EXPECT_EQ(cells.operands, again.operands);
}

TEST(ActiveCells, have_longer_lists_when_time_runs_out) {
    std::mt19937 random(21);
    const Scene scene(random, 300, 1);
    const Region box{glm::dvec3(0), glm::dvec3(1), false};
    const std::vector<std::uint32_t> all = all_of(scene);
    const auto found = [&](const Budget* budget) {
        return active_cells({.minima = {{scene.operands, 0.05}}}, box, budget);
    };
    const ActiveCells fine = found(nullptr);
    std::uniform_real_distribution<double> place(-1, 1);
    double longest = 1e9;
    for (const int questions : {0, 1, 200, 1000, 3000, 10'000'000}) {
        const Budget budget = over_after(questions);
        const ActiveCells cells = found(&budget);
        EXPECT_EQ(budget.was_over(), questions < 10'000'000) << questions;
        double length = 0;
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 p(place(random), place(random), place(random));
            const std::span list = cells.of(cells.cells[cells.at(p).cell].place);
            const std::span closer = fine.of(fine.cells[fine.at(p).cell].place);
            ASSERT_NEAR(scene.minimum(list, p, 0.05), scene.minimum(all, p, 0.05), 2e-9);
            // Whatever can matter in a part can matter in the whole.
            ASSERT_GE(list.size(), closer.size()) << questions;
            length += static_cast<double>(list.size());
        }
        EXPECT_LE(length, 1.1 * longest) << questions;
        longest = length;
    }
    const Budget enough = over_after(10'000'000);
    EXPECT_EQ(found(&enough).operands, fine.operands);
}

}  // namespace
}  // namespace analysis
