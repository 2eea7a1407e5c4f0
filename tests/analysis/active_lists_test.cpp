// SPDX-License-Identifier: MIT
// Lists of operands that can matter in a cell, against all operands at many points.
#include "analysis/active_lists.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <glm/glm.hpp>

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

std::size_t cell_of(const ActiveLists& lists, const glm::dvec3& p) {
    const glm::ivec3 cell(glm::floor((p - lists.origin) / lists.size));
    EXPECT_TRUE(glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))));
    EXPECT_TRUE(glm::all(glm::lessThan(cell, lists.count)));
    return static_cast<std::size_t>((cell.z * lists.count.y + cell.y) * lists.count.x + cell.x);
}

TEST(ActiveLists, have_the_minimum_of_all_operands_at_every_point_of_a_cell) {
    const std::uint32_t seed = 20261122;
    std::mt19937 random(seed);
    for (int round = 0; round < 12; ++round) {
        const int count = 20 + 60 * round;
        const Scene scene(random, count, round % 2 == 0 ? 1 : 0.4);
        const std::optional<double> width =
            round % 3 == 0 ? std::nullopt : std::optional(round % 3 == 1 ? 0.02 : 0.3);
        const Region region{{0.1, -0.2, 0}, {0.9, 1.2, 0.7}, false};
        const Cell box = bounding_cell(region);
        const ActiveLists lists = active_lists(scene.operands, region, width);
        const std::vector<std::uint32_t> all = all_of(scene);
        std::uniform_real_distribution<double> unit(0, 1);
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 part(unit(random), unit(random), unit(random));
            const glm::dvec3 p = glm::mix(box.low, box.high, part);
            const double expected = scene.minimum(all, p, width);
            const double found = scene.minimum(lists.of(cell_of(lists, p)), p, width);
            ASSERT_NEAR(found, expected, 1e-12 + 3e-8 * width.value_or(0))
                << "seed " << seed << ", round " << round << ", point " << i;
        }
    }
}

TEST(ActiveLists, hold_few_of_many_operands) {
    std::mt19937 random(7);
    const Scene scene(random, 1000, 1);
    const Region box{glm::dvec3(0), glm::dvec3(1), false};
    const ActiveLists plain = active_lists(scene.operands, box, std::nullopt);
    const ActiveLists smooth = active_lists(scene.operands, box, 0.05);
    const auto average = [](const ActiveLists& lists) {
        double sum = 0;
        for (std::size_t i = 0; i < lists.cells.size(); ++i) {
            sum += static_cast<double>(lists.of(i).size());
        }
        return sum / static_cast<double>(lists.cells.size());
    };
    EXPECT_LT(average(plain), 12);
    EXPECT_LT(average(smooth), 40);
    EXPECT_GT(average(plain), 1);
}

TEST(ActiveLists, are_empty_outside_of_a_ball_and_only_there) {
    std::mt19937 random(9);
    const Scene scene(random, 100, 1);
    const Region ball{glm::dvec3(0.5), glm::dvec3(1), true};
    const ActiveLists lists = active_lists(scene.operands, ball, std::nullopt);
    std::size_t empty = 0;
    for (std::size_t i = 0; i < lists.cells.size(); ++i) {
        const auto cell = static_cast<int>(i);
        const glm::dvec3 place(cell % lists.count.x, cell / lists.count.x % lists.count.y,
                               cell / (lists.count.x * lists.count.y));
        const glm::dvec3 low = lists.origin + lists.size * place;
        const glm::dvec3 nearest = glm::clamp(ball.centre, low, low + lists.size);
        if (lists.of(i).empty()) {
            EXPECT_GT(glm::distance(nearest, ball.centre), 1) << i;
        }
        empty += lists.of(i).empty();
    }
    EXPECT_GT(empty, lists.cells.size() / 4);
}

TEST(ActiveLists, are_in_order_and_the_same_each_time) {
    std::mt19937 random(3);
    const Scene scene(random, 300, 1);
    const Region box{glm::dvec3(0), glm::dvec3(1), false};
    const ActiveLists lists = active_lists(scene.operands, box, 0.1);
    for (std::size_t i = 0; i < lists.cells.size(); ++i) {
        EXPECT_TRUE(std::ranges::is_sorted(lists.of(i))) << i;
    }
    const ActiveLists again = active_lists(scene.operands, box, 0.1);
    EXPECT_EQ(lists.cells, again.cells);
    EXPECT_EQ(lists.begins, again.begins);
    EXPECT_EQ(lists.operands, again.operands);
}

}  // namespace
}  // namespace analysis
