// SPDX-License-Identifier: MIT
// The built-in solids against distances that are found in another way: from the nearest point of
// the surface.
#include "field/primitives.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "field/shapes.h"

namespace field {
namespace {

using glm::dvec3;

/// A point of the half plane around the z axis.
struct Profile {
    double rho = 0;
    double z = 0;
};

Profile profile(dvec3 p) { return {std::hypot(p.x, p.y), p.z}; }

double distance_to_segment(Profile p, Profile a, Profile b) {
    const double along_rho = b.rho - a.rho, along_z = b.z - a.z;
    const double part = ((p.rho - a.rho) * along_rho + (p.z - a.z) * along_z) /
                        (along_rho * along_rho + along_z * along_z);
    const double t = std::clamp(part, 0.0, 1.0);
    return std::hypot(p.rho - a.rho - t * along_rho, p.z - a.z - t * along_z);
}

void expect_distance(const Field& field, unsigned seed,
                     const std::function<double(dvec3)>& expected) {
    Random random(seed);
    int inside = 0;
    constexpr int points = 3000;
    for (int i = 0; i < points; ++i) {
        const dvec3 p = random_point(random, i % 2 == 0 ? 3 : 1);
        const double distance = expected(p);
        inside += distance < 0;
        ASSERT_NEAR(value(field, p), distance, 1e-12) << "seed " << seed << ": " << describe(p);
    }
    EXPECT_GT(inside, points / 50) << "too few points inside to tell";
    expect_lipschitz(field, seed, 3, 1000);
}

TEST(Primitives, are_sorted_by_name_and_found_by_it) {
    EXPECT_TRUE(std::ranges::is_sorted(primitives(), {}, &Primitive::name));
    for (const Primitive& primitive : primitives()) {
        EXPECT_EQ(find_primitive(primitive.name), &primitive);
    }
    EXPECT_EQ(find_primitive("spher"), nullptr);
}

TEST(Primitives, build_with_their_defaults) {
    for (const Primitive& primitive : primitives()) {
        Field f;
        std::vector<graph::NodeId> arguments;
        for (const Argument& argument : primitive.arguments) {
            for (const double number : argument.initial) {
                arguments.push_back(f.graph.constant(number));
            }
        }
        f.root = primitive.build(f, arguments);
        EXPECT_EQ(kind_of(f, f.root), Kind::solid) << primitive.name;
        EXPECT_TRUE(std::isfinite(value(f, {3, 4, 5}))) << primitive.name;
    }
}

TEST(Primitives, sphere_is_an_exact_distance) {
    expect_distance(primitive("sphere", {1.25}), 1, [](dvec3 p) { return glm::length(p) - 1.25; });
}

TEST(Primitives, box_is_an_exact_distance) {
    const dvec3 half(0.5, 1, 0.75);
    expect_distance(primitive("box", {half.x, half.y, half.z}), 2, [&](dvec3 p) {
        const dvec3 nearest = glm::clamp(p, -half, half);
        if (nearest != p) return glm::distance(p, nearest);
        return -std::min({half.x - std::abs(p.x), half.y - std::abs(p.y), half.z - std::abs(p.z)});
    });
}

TEST(Primitives, torus_is_an_exact_distance) {
    expect_distance(primitive("torus", {1, 0.4}), 3, [](dvec3 p) {
        const double angle = std::atan2(p.y, p.x);
        const dvec3 nearest(std::cos(angle), std::sin(angle), 0);
        return glm::distance(p, nearest) - 0.4;
    });
}

TEST(Primitives, cylinder_is_an_exact_distance) {
    expect_distance(primitive("cylinder", {0.7, 1.2}), 4, [](dvec3 p) {
        const Profile q = profile(p);
        const double wall = distance_to_segment(q, {0.7, -1.2}, {0.7, 1.2});
        const double lid = std::min(distance_to_segment(q, {0, 1.2}, {0.7, 1.2}),
                                    distance_to_segment(q, {0, -1.2}, {0.7, -1.2}));
        const bool inside = q.rho < 0.7 && std::abs(q.z) < 1.2;
        return std::min(wall, lid) * (inside ? -1 : 1);
    });
}

TEST(Primitives, cone_is_an_exact_distance) {
    expect_distance(primitive("cone", {1, 0.8}), 5, [](dvec3 p) {
        const Profile q = profile(p);
        const double side = distance_to_segment(q, {0, 0.8}, {1, -0.8});
        const double base = distance_to_segment(q, {0, -0.8}, {1, -0.8});
        const bool inside = q.z > -0.8 && q.rho < (0.8 - q.z) / 1.6;
        return std::min(side, base) * (inside ? -1 : 1);
    });
}

TEST(Primitives, capsule_is_an_exact_distance) {
    expect_distance(primitive("capsule", {0.5, 0.9}), 6, [](dvec3 p) {
        return distance_to_segment(profile(p), {0, -0.9}, {0, 0.9}) - 0.5;
    });
}

TEST(Primitives, plane_is_an_exact_distance_for_normals_of_any_length) {
    const dvec3 normal = glm::normalize(dvec3(1, 2, -2));
    expect_distance(primitive("plane", {10, 20, -20, 0.3}), 7, [&](dvec3 p) {
        const dvec3 foot = 0.3 * normal;
        return glm::dot(p - foot, normal);
    });
}

TEST(Primitives, superquadric_has_its_surface_and_a_bound_of_the_distance) {
    constexpr unsigned seed = 8;
    Random random(seed);
    for (const auto& [p, q] : {std::pair{1.0, 1.0},
                               {1.0, 3.0},
                               {1.4, 1.2},
                               {2.0, 2.0},
                               {4.0, 2.5},
                               {3.0, 1.0},
                               {10.0, 30.0}}) {
        const Field field = primitive("superquadric", {p, q});
        for (int i = 0; i < 1000; ++i) {
            const dvec3 at = glm::abs(random_point(random, 2));
            const double sum =
                std::pow(std::pow(at.x, p) + std::pow(at.y, p), q / p) + std::pow(at.z, q);
            const double norm = std::pow(sum, 1 / q);
            EXPECT_NEAR(value(field, at / norm), 0, 1e-14) << p << ", " << q << describe(at);
            EXPECT_EQ(value(field, at) < 0, norm < 1) << p << ", " << q << describe(at);
        }
        expect_lipschitz(field, seed, 3, 1000);
        EXPECT_EQ(std::get<Formula>(field[field.root]).exact, false);
    }
    const Field ball = primitive("superquadric", {2, 2});
    EXPECT_NEAR(value(ball, {3, 4, 12}), 12, 1e-14);
    // Smaller exponents are those of an octahedron.
    EXPECT_EQ(value(primitive("superquadric", {0.5, -3}), {0.25, 0.25, 0.5}), 0);
}

TEST(Primitives, have_the_values_that_can_be_read_off) {
    EXPECT_EQ(value(primitive("sphere", {2}), {0, 0, 0}), -2);
    EXPECT_EQ(value(primitive("box", {1, 2, 3}), {0, 0, 0}), -1);
    EXPECT_EQ(value(primitive("box", {1, 2, 3}), {4, 6, 3}), 5);
    EXPECT_EQ(value(primitive("torus", {2, 0.5}), {0, 0, 0}), 1.5);
    EXPECT_EQ(value(primitive("cylinder", {1, 2}), {4, 0, 6}), 5);
    EXPECT_EQ(value(primitive("cone", {3, 2}), {0, 0, 5}), 3) << "above the apex";
    EXPECT_EQ(value(primitive("cone", {3, 2}), {0, 0, -3}), 1) << "below the base";
    EXPECT_EQ(value(primitive("capsule", {1, 2}), {0, 0, 5}), 2);
    EXPECT_EQ(value(primitive("plane", {0, 0, 1, 0.5}), {7, 8, 2}), 1.5);
}

}  // namespace
}  // namespace field
