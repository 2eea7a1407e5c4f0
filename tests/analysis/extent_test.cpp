// SPDX-License-Identifier: MIT
// What is proven of where scenes are: boxes of shapes that are known, and no false proof for any.
#include "analysis/extent.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "analysis/random_scene.h"
#include "analysis/smoothness.h"
#include "eval/field_value.h"
#include "field/shapes.h"
#include "graph/build.h"

namespace analysis {
namespace {

using graph::Expr;

constexpr Effort effort{.cells = 5000, .tolerance = 1.0 / 512};
constexpr Region ball{};  // of radius 2
constexpr Region cube{glm::dvec3(0), glm::dvec3(2), false};

/// A sheet or solid of one expression of the point.
template <class Build>
field::Field formula(Build build, field::Kind kind = field::Kind::solid) {
    field::Field field;
    const auto at = [&](graph::VariableId id) {
        return Expr(field.graph, field.graph.variable(id));
    };
    const Expr f = build(at(graph::variable_x), at(graph::variable_y), at(graph::variable_z));
    field.root = field.add(field::Formula{f.id, field::Metric::scalar, kind});
    return field;
}

ContentFinder content_of(const field::Field& field) { return {field, field.root, {}}; }

/// The box is around [low, high], at most 1/64 too large on each side.
void expect_box(const field::Field& field, const Region& region, glm::dvec3 low, glm::dvec3 high) {
    ContentFinder content = content_of(field);
    const std::optional<Cell> box = bounding_box(content, region, effort);
    ASSERT_TRUE(box);
    for (int i = 0; i < 3; ++i) {
        EXPECT_LE(box->low[i], low[i]) << i;
        EXPECT_GE(box->low[i], low[i] - 1.0 / 64) << i;
        EXPECT_GE(box->high[i], high[i]) << i;
        EXPECT_LE(box->high[i], high[i] + 1.0 / 64) << i;
    }
}

Reach reach_of(const field::Field& field, const Region& region) {
    ContentFinder content = content_of(field);
    return reach(content, region, bounding_box(content, region, effort).value(), effort);
}

TEST(BoundingBox, of_built_in_solids) {
    expect_box(field::primitive("sphere", {1.25}), ball, glm::dvec3(-1.25), glm::dvec3(1.25));
    expect_box(field::primitive("box", {1, 0.5, 0.25}), ball, {-1, -0.5, -0.25}, {1, 0.5, 0.25});
    expect_box(field::primitive("torus", {1, 0.35}), ball, {-1.35, -1.35, -0.35},
               {1.35, 1.35, 0.35});
    expect_box(field::primitive("cylinder", {0.5, 1}), ball, {-0.5, -0.5, -1}, {0.5, 0.5, 1});
    expect_box(field::primitive("capsule", {0.5, 1}), ball, {-0.5, -0.5, -1.5}, {0.5, 0.5, 1.5});
    expect_box(field::primitive("cone", {1, 1}), ball, {-1, -1, -1}, {1, 1, 1});
}

TEST(BoundingBox, of_surfaces_with_a_known_extent) {
    const auto ellipsoid =
        formula([](Expr x, Expr y,
                   Expr z) { return x * x + 4.0 * (y * y) + 16.0 * (z - 0.5) * (z - 0.5) - 1.0; },
                field::Kind::sheet);
    expect_box(ellipsoid, ball, {-1, -0.5, 0.25}, {1, 0.5, 0.75});
    // The part of a plane that is in the ball of radius 2.
    const auto plane = formula([](Expr x, Expr, Expr) { return x - 1.0; }, field::Kind::sheet);
    expect_box(plane, ball, {1, -std::sqrt(3.0), -std::sqrt(3.0)},
               {1, std::sqrt(3.0), std::sqrt(3.0)});
    expect_box(plane, cube, {1, -2, -2}, {1, 2, 2});
}

TEST(BoundingBox, of_combinations) {
    field::Field field;
    const auto ball_of = [&](double r) { return field::add_primitive(field, "sphere", {r}); };
    const auto upper = field::add_primitive(field, "plane", {0, 0, -1, 0});
    field.root = field.add(field::Intersection{ball_of(1), upper});
    expect_box(field, ball, {-1, -1, 0}, {1, 1, 1});
    field.root = field.add(field::Union{field.root, ball_of(1.5)});
    expect_box(field, ball, glm::dvec3(-1.5), glm::dvec3(1.5));
    const auto outside = field.add(field::Complement{ball_of(1)});
    field.root = outside;
    expect_box(field, cube, glm::dvec3(-2), glm::dvec3(2));
    field.root = field.add(field::Intersection{ball_of(1.25), outside});
    expect_box(field, cube, glm::dvec3(-1.25), glm::dvec3(1.25));
}

TEST(BoundingBox, of_an_iteration_holds_it) {
    // The set of q^2 is the unit disk.
    field::Field field;
    graph::Graph& g = field.graph;
    const graph::VariableId ids[] = {g.new_variable("a"), g.new_variable("b")};
    const Expr x(g, g.variable(graph::variable_x)), y(g, g.variable(graph::variable_y));
    const Expr a(g, g.variable(ids[0])), b(g, g.variable(ids[1]));
    const Expr square = a * a + b * b;
    field.root = field.add(field::Iteration{{ids[0], ids[1]},
                                            {x.id, y.id},
                                            {(a * a - b * b).id, (2.0 * a * b).id},
                                            g.constant(8),
                                            (square - 16.0).id,
                                            (0.5 * log(square)).id});
    ContentFinder content = content_of(field);
    const Region slab{glm::dvec3(0), {2, 2, 1.0 / 64}, false};
    const auto box = bounding_box(content, slab, effort);
    ASSERT_TRUE(box);
    for (int i = 0; i < 2; ++i) {
        EXPECT_LE(box->low[i], -1);
        EXPECT_GE(box->low[i], -1.1);
        EXPECT_GE(box->high[i], 1);
        EXPECT_LE(box->high[i], 1.1);
    }
}

TEST(Extent, knows_what_is_empty_and_what_is_full) {
    const auto far = formula([](Expr x, Expr y, Expr z) { return hypot(x - 5.0, y, z) - 1.0; });
    ContentFinder content = content_of(far);
    EXPECT_TRUE(proven_empty(content, ball, effort));
    EXPECT_FALSE(proven_full(content, ball, effort));
    EXPECT_FALSE(proven_empty_everywhere(content));
    EXPECT_FALSE(bounding_box(content, ball, effort));
    const auto large = formula([](Expr x, Expr y, Expr z) { return hypot(x, y, z) - 9.0; });
    ContentFinder filled = content_of(large);
    EXPECT_FALSE(proven_empty(filled, ball, effort));
    EXPECT_TRUE(proven_full(filled, ball, effort));
    const auto nowhere = formula([](Expr x, Expr y, Expr) { return x * x + y * y + 1.0; });
    ContentFinder none = content_of(nowhere);
    EXPECT_TRUE(proven_empty_everywhere(none));
    // Outside of the domain is outside, also of a complement's inside.
    const auto root = formula([](Expr x, Expr, Expr) { return sqrt(x - 3.0) - 9.0; });
    ContentFinder edge = content_of(root);
    EXPECT_TRUE(proven_empty(edge, ball, effort));
}

TEST(Extent, takes_nothing_for_granted_behind_a_division_by_zero) {
    // ceil is -0 from -1 to 0, where the quotient is -infinity: inside, although undefined.
    const auto f = formula([](Expr x, Expr, Expr) {
        return 1.0 / Expr(*x.graph, x.graph->apply(graph::Op::ceil, x.id));
    });
    const Region part{{-0.5, 0, 0}, glm::dvec3(0.25), false};
    ContentFinder content = content_of(f);
    ASSERT_LT(eval::value(f, f.root, {-0.5, 0, 0}, {}), 0);
    EXPECT_FALSE(proven_empty(content, part, effort));
}

TEST(Extent, proves_no_more_than_is_true_where_surfaces_touch_the_region) {
    const auto touching = formula([](Expr x, Expr, Expr) { return 2.0 - x; });
    ContentFinder content = content_of(touching);
    EXPECT_FALSE(proven_empty(content, cube, effort));
    EXPECT_FALSE(proven_empty(content, ball, effort));
}

TEST(Reach, is_bounded_where_all_of_space_is_clear) {
    EXPECT_EQ(reach_of(field::primitive("sphere", {1}), ball), Reach::bounded);
    EXPECT_EQ(reach_of(field::primitive("box", {1, 1, 1}), ball), Reach::bounded);
}

TEST(Reach, is_contained_where_the_walls_are_clear) {
    // In all of space x^4 - 3x^2 is the difference of two infinities to an interval.
    const auto cushion = formula([](Expr x, Expr y, Expr z) {
        const Expr x2 = x * x;
        return x2 * x2 - 3.0 * x2 + y * y + z * z + 2.0;
    });
    EXPECT_EQ(reach_of(cushion, ball), Reach::contained);
    EXPECT_EQ(reach_of(cushion, cube), Reach::contained);
}

TEST(Reach, is_open_where_it_meets_the_walls) {
    EXPECT_EQ(reach_of(field::primitive("plane", {0, 0, 1, 0}), ball), Reach::open);
    EXPECT_EQ(reach_of(field::primitive("plane", {0, 0, 1, 0}), cube), Reach::open);
    EXPECT_EQ(reach_of(field::primitive("cylinder", {0.5, 3}), cube), Reach::open);
    EXPECT_EQ(reach_of(field::primitive("sphere", {3}), cube), Reach::open);
}

/// A random cell in the ball's bounding box, often a thin or tiny one.
Cell random_cell(eval::Random& random) {
    Cell cell;
    for (int i = 0; i < 3; ++i) {
        const double size = std::exp2(-static_cast<double>(random() % 12));
        const double place = std::uniform_real_distribution<double>(-2, 2)(random);
        cell.low[i] = place;
        cell.high[i] = place + (random() % 8 == 0 ? 0 : size);
    }
    return cell;
}

glm::dvec3 random_point(eval::Random& random, const Cell& cell) {
    glm::dvec3 p;
    for (int i = 0; i < 3; ++i) {
        const std::uint64_t end = random() % 8;
        p[i] = end == 0   ? cell.low[i]
               : end == 1 ? cell.high[i]
                          : glm::clamp(std::uniform_real_distribution<double>(
                                           cell.low[i], std::nextafter(cell.high[i], 9))(random),
                                       cell.low[i], cell.high[i]);
    }
    return p;
}

TEST(Content, holds_the_value_at_every_point_of_a_cell) {
    constexpr unsigned seed = 20261;
    eval::Random random(seed);
    for (int round = 0; round < 3000; ++round) {
        const RandomScene scene(random, false);
        ContentFinder finder(scene.field, scene.field.root, scene.parameters);
        for (int i = 0; i < 4; ++i) {
            const Cell cell = random_cell(random);
            const Content content = finder.over(cell);
            for (int k = 0; k < 4; ++k) {
                const glm::dvec3 p = random_point(random, cell);
                const double value =
                    eval::value(scene.field, scene.field.root, p, scene.parameters);
                // The smooth minimum is no operator of the graph and rounds on its own.
                const double slack = 1e-12 * (1 + std::min(std::abs(value), 1e300));
                ASSERT_LE(content.solid.lo, value + slack)
                    << "seed " << seed << " round " << round << " at " << field::describe(p);
                ASSERT_GE(content.solid.hi, value - slack)
                    << "seed " << seed << " round " << round << " at " << field::describe(p);
            }
        }
    }
}

TEST(Extent, never_proves_what_samples_refute) {
    constexpr unsigned seed = 20262;
    eval::Random random(seed);
    int empty = 0, full = 0;
    for (int round = 0; round < 1500; ++round) {
        const RandomScene scene(random, false);
        ContentFinder finder(scene.field, scene.field.root, scene.parameters);
        const Effort little{.cells = 300, .tolerance = 1.0 / 64, .depth = 20};
        const bool is_empty = proven_empty(finder, ball, little);
        const bool is_full = proven_full(finder, ball, little);
        const auto box = bounding_box(finder, ball, little);
        EXPECT_TRUE(box || !is_full);
        empty += is_empty;
        full += is_full;
        for (unsigned i = 0; i < 100; ++i) {
            const glm::dvec3 p = spread_point(ball, i);
            const bool inside =
                eval::value(scene.field, scene.field.root, p, scene.parameters) <= -1e-9;
            const bool outside =
                eval::value(scene.field, scene.field.root, p, scene.parameters) > 1e-9;
            ASSERT_FALSE(inside && is_empty) << "seed " << seed << " round " << round;
            ASSERT_FALSE(outside && is_full) << "seed " << seed << " round " << round;
            if (!inside) continue;
            ASSERT_TRUE(box) << "seed " << seed << " round " << round;
            ASSERT_TRUE(glm::all(glm::lessThanEqual(box->low, p)) &&
                        glm::all(glm::lessThanEqual(p, box->high)))
                << "seed " << seed << " round " << round << " at " << field::describe(p);
        }
    }
    EXPECT_GT(empty, 100);
    EXPECT_GT(full, 100);
}

TEST(Extent, of_a_sheet_is_never_empty_where_a_continuous_formula_changes_its_sign) {
    constexpr unsigned seed = 20263;
    eval::Random random(seed);
    int empty = 0, changes = 0;
    for (int round = 0; round < 3000; ++round) {
        const RandomScene scene(random, true);
        const auto* leaf = std::get_if<field::Formula>(&scene.field[scene.field.root]);
        if (!leaf) continue;
        ContentFinder finder(scene.field, scene.field.root, scene.parameters);
        const Effort little{.cells = 300, .depth = 20};
        const bool is_empty = proven_empty(finder, ball, little);
        const Regularity known =
            regularity(scene.field.graph, leaf->value, ball, scene.parameters, little);
        const bool continuous = !known.partial && known.smoothness != Smoothness::discontinuous;
        bool below = false, above = false;
        for (unsigned i = 0; i < 200; ++i) {
            const double value = eval::evaluate(scene.field.graph, leaf->value,
                                                spread_point(ball, i), scene.parameters);
            ASSERT_FALSE(value == 0 && is_empty) << "seed " << seed << " round " << round;
            below = below || value < 0;
            above = above || value > 0;
        }
        empty += is_empty;
        changes += below && above;
        ASSERT_FALSE(is_empty && continuous && below && above)
            << "seed " << seed << " round " << round;
    }
    EXPECT_GT(empty, 100);
    EXPECT_GT(changes, 100);
}

}  // namespace
}  // namespace analysis
