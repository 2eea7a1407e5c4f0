// SPDX-License-Identifier: MIT
#include "analysis/jacobian_norm.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "analysis/image_region.h"
#include "graph/build.h"

namespace analysis {
namespace {

using graph::Expr;
using numeric::Interval;

struct Map {
    graph::Graph graph;
    Expr x{graph, graph.variable(graph::variable_x)};
    Expr y{graph, graph.variable(graph::variable_y)};
    Expr z{graph, graph.variable(graph::variable_z)};

    double norm(Expr a, Expr b, Expr c, const Region& region) {
        return jacobian_norm_bound(eval::make_tape(graph, std::array{a.id, b.id, c.id}), region,
                                   std::array{0.0});
    }
    std::optional<Region> image(Expr a, Expr b, Expr c, const Region& region) {
        const auto tape = [&](Expr e) { return eval::make_tape(graph, std::array{e.id}); };
        return image_region({tape(a), tape(b), tape(c)}, region, std::array{0.0});
    }
};

const Region ball{glm::dvec3(0), glm::dvec3(2), true};

TEST(StretchBound, is_the_largest_singular_value) {
    const auto near = [](double bound, double norm) {
        EXPECT_GE(bound, norm * (1 - 1e-14));
        EXPECT_LE(bound, norm * 1.02);
    };
    near(stretch_bound(Matrix<double>{{{3, 0, 0}, {0, -7, 0}, {0, 0, 5}}}), 7);
    near(stretch_bound(Matrix<double>{{{0, 2, 0}, {0, 0, 0}, {0, 0, 0}}}), 2);
    near(stretch_bound(Matrix<double>{{{0, 1e200, 0}, {0, 0, 0}, {0, 0, 0}}}), 1e200);
    // A shear by k has the norm (k + sqrt(k^2 + 4)) / 2.
    near(stretch_bound(Matrix<double>{{{1, 3, 0}, {0, 1, 0}, {0, 0, 1}}}),
         (3 + std::sqrt(13.0)) / 2);
    EXPECT_EQ(stretch_bound(Matrix<double>{}), 0);
    EXPECT_EQ(stretch_bound(Matrix<double>{{{numeric::infinity, 0, 0}, {}, {}}}),
              numeric::infinity);
}

TEST(StretchBound, of_intervals_is_above_every_vector_that_is_stretched) {
    constexpr unsigned seed = 51;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-2, 2), part(0, 1);
    for (int i = 0; i < 2000; ++i) {
        Matrix<Interval> a{};
        for (auto& row : a) {
            for (Interval& entry : row) {
                const double p = uniform(random), q = uniform(random);
                entry = {std::min(p, q), std::max(p, q)};
            }
        }
        const double v[3] = {uniform(random), uniform(random), uniform(random)};
        double square = 0;
        for (const auto& row : a) {
            double sum = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                sum += (row[k].lo + part(random) * (row[k].hi - row[k].lo)) * v[k];
            }
            square += sum * sum;
        }
        const double length = std::hypot(v[0], v[1], v[2]);
        ASSERT_GE(stretch_bound(a) * length, std::sqrt(square)) << "seed " << seed;
    }
}

TEST(JacobianNorm, of_an_isometry_is_one) {
    Map m;
    const double c = std::cos(0.7), s = std::sin(0.7);
    const double turn = m.norm(c * m.x + s * m.y, c * m.y - s * m.x, m.z + 5.0, ball);
    EXPECT_GE(turn, 1);
    EXPECT_LE(turn, 1.02);
    EXPECT_LE(m.norm(abs(m.x), m.y, m.z, ball), 1.02) << "kinks do not matter";
}

/// K 34-37: with the rate k of the angle and the distance r from the axis it is
/// (k r + sqrt(k^2 r^2 + 4)) / 2.
TEST(JacobianNorm, of_a_twist_is_that_of_the_known_formula) {
    for (const double k : {0.3, 1.0, 3.0}) {
        Map m;
        const double bound = jacobian_norm_bound(
            eval::make_tape(m.graph, std::array{m.x.id, m.y.id, m.z.id, (k * m.z).id}), ball,
            std::array{0.0});
        const double exact = (2 * k + std::sqrt(4 * k * k + 4)) / 2;
        EXPECT_GE(bound, exact) << k;
        EXPECT_LE(bound, 1.08 * exact) << k;
        // The same map without the knowledge that it is a turn.
        const Expr c = cos(k * m.z), s = sin(k * m.z);
        const double blind = m.norm(c * m.x + s * m.y, c * m.y - s * m.x, m.z, ball);
        EXPECT_GE(blind, exact) << k;
        EXPECT_LE(blind, 1.5 * exact) << k;
    }
}

TEST(JacobianNorm, is_unknown_across_jumps_and_poles) {
    Map m;
    EXPECT_EQ(m.norm(floor(m.x), m.y, m.z, ball), numeric::infinity);
    EXPECT_EQ(m.norm(1.0 / m.x, m.y, m.z, ball), numeric::infinity);
    EXPECT_EQ(m.norm(sqrt(m.x), m.y, m.z, ball), numeric::infinity);
    EXPECT_LT(m.norm(1.0 / (m.x + 3.0), m.y, m.z, ball), 1.1);
}

TEST(JacobianNorm, of_a_linear_map_holds_in_all_of_space) {
    Map m;
    const Region space{glm::dvec3(0), glm::dvec3(numeric::infinity), false};
    EXPECT_NEAR(m.norm(3.0 * m.x, m.y - 1.0, m.z, space), 3, 0.06);
    EXPECT_EQ(m.norm(m.x * m.x, m.y, m.z, space), numeric::infinity);
}

TEST(ImageRegion, holds_the_image_and_little_more) {
    Map m;
    const auto image = m.image(m.x * m.x, m.y + 10.0, m.z - floor(m.z + 0.5), ball);
    ASSERT_TRUE(image);
    const auto side = [&](int axis) {
        return std::pair{image->centre[axis] - image->half[axis],
                         image->centre[axis] + image->half[axis]};
    };
    EXPECT_LE(side(0).first, 0);
    EXPECT_GE(side(0).first, -0.5);
    EXPECT_GE(side(0).second, 4);
    EXPECT_LE(side(0).second, 4.5);
    EXPECT_LE(side(1).first, 8);
    EXPECT_GE(side(1).first, 6.5);
    EXPECT_GE(side(1).second, 12);
    EXPECT_LE(side(1).second, 13.5);
    EXPECT_LE(side(2).first, -0.5);
    EXPECT_GE(side(2).first, -0.6);
    EXPECT_GE(side(2).second, 0.5);
    EXPECT_LE(side(2).second, 0.6);
    EXPECT_FALSE(m.image(1.0 / m.x, m.y, m.z, ball));
}

}  // namespace
}  // namespace analysis
