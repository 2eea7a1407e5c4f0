// SPDX-License-Identifier: MIT
// References of shapes made of polynomial parts, against roots found another way.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include <glm/geometric.hpp>

#include "oracle/traced.h"
#include "render_answers/exact_shape.h"

namespace oracle {
namespace {

using render_answers::Crossing;
using render_answers::Polynomial;
using render_answers::Sheet;
using render_answers::Solid;

struct Known {
    std::string formula;
    std::variant<Solid, Sheet> shape;
    scene::Bounds bounds{};
    scene::Camera camera = Scene{}.camera;
};

struct Answer {
    double depth = std::numeric_limits<double>::infinity();
    glm::dvec3 normal{0};
};

/// The first surface by the roots of the polynomials along the ray.
Answer answer(const Known& known, const render_answers::Ray& ray) {
    const Solid region = known.bounds.shape == scene::Bounds::Shape::none
                             ? render_answers::ball(scene::far_distance, ray.origin)
                             : render_answers::inside(known.bounds);
    std::vector<Crossing> crossings;
    if (const Solid* solid = std::get_if<Solid>(&known.shape)) {
        using render_answers::operator&;
        const Solid capped = *solid & region;
        for (const render_answers::Span& span : capped(ray)) {
            if (span.leave.t < 0) continue;
            if (span.enter.t <= 0) return {0, glm::dvec3(0)};
            crossings.push_back(span.enter);
        }
    } else {
        const Sheet inside = std::get<Sheet>(known.shape) & region;
        crossings = inside(ray);
    }
    for (const Crossing& crossing : crossings) {
        if (crossing.t < 0) continue;
        const glm::dvec3 n = glm::normalize(crossing.normal);
        return {crossing.t, glm::dot(n, ray.direction) > 0 ? -n : n};
    }
    return {};
}

void check(const Known& known) {
    Scene scene{.formula = known.formula, .bounds = known.bounds, .camera = known.camera};
    scene.width = 40;
    scene.height = 30;
    const Reference reference = traced(scene);
    int undecided = 0, hits = 0;
    for (int y = 0; y < scene.height; ++y) {
        for (int x = 0; x < scene.width; ++x) {
            const render_answers::Ray ray = render_answers::ray_through(
                scene.camera, scene.width, scene.height, x + 0.5, y + 0.5);
            const Pixel& pixel = reference.at(x, y);
            const Answer expected = answer(known, ray);
            const std::string where =
                known.formula + " at " + std::to_string(x) + "," + std::to_string(y);
            if (pixel.verdict == Verdict::undecided) {
                ++undecided;
                EXPECT_LE(pixel.near, expected.depth * (1 + 1e-12)) << where;
                continue;
            }
            ASSERT_EQ(pixel.verdict == Verdict::hit, std::isfinite(expected.depth)) << where;
            if (pixel.verdict == Verdict::miss) {
                EXPECT_EQ(pixel.depth(), std::numeric_limits<double>::infinity());
                EXPECT_EQ(pixel.object, -1);
                continue;
            }
            ++hits;
            // The other roots are good to about 1e-11.
            const double slack = 1e-10 * expected.depth;
            EXPECT_LE(pixel.near, expected.depth + slack) << where;
            EXPECT_GE(pixel.far, expected.depth - slack) << where;
            EXPECT_LE(pixel.far - pixel.near, 1e-9 * pixel.far) << where;
            EXPECT_NEAR(glm::length(pixel.normal), 1, 1e-12) << where;
            if (expected.depth == 0 || pixel.fragile) continue;
            EXPECT_LT(glm::distance(pixel.normal, expected.normal), 1e-6) << where;
        }
    }
    EXPECT_GT(hits, 0) << known.formula;
    EXPECT_LE(undecided, 2) << known.formula;
}

scene::Bounds box(double x, double y, double z) {
    return {scene::Bounds::Shape::box, glm::dvec3(0), {x, y, z}};
}

TEST(KnownShapes, solids_are_hit_where_their_polynomials_are_zero) {
    using namespace render_answers;
    check({"sphere(1)", ball(1)});
    check({"x^2 + y^2 + z^2 <= 1", ball(1)});
    check({"box(0.7, 0.5, 0.9)", cuboid({0.7, 0.5, 0.9})});
    check({"torus(1, 0.4)", torus(1, 0.4)});
    check({"cylinder(0.6, 0.9)", cylinder(0.6, 0.9)});
    check({"box(0.8, 0.8, 0.8) \\ sphere(1)", cuboid(glm::dvec3(0.8)) & !ball(1)});
    check({"sphere(1) & (x + 2y <= 0.3)", ball(1) & half_space(1, 2, 0, 0.3)});
    check({"translate(sphere(0.8), (0.5, 0, 0)) | translate(sphere(0.7), (-0.4, 0.3, 0))",
           ball(0.8, {0.5, 0, 0}) | ball(0.7, {-0.4, 0.3, 0})});
}

TEST(KnownShapes, solids_are_capped_at_the_bounds) {
    using namespace render_answers;
    check({"x + y <= 0.25", half_space(1, 1, 0, 0.25)});
    check({"x + y <= 0.25", half_space(1, 1, 0, 0.25), box(0.7, 1.2, 0.9)});
    check({"x^2 + y^2 >= 0.5",
           !(below([](const Polynomial& x, const Polynomial& y, const Polynomial&) {
               return x * x + y * y - 0.5;
           })),
           box(1, 1, 1)});
}

TEST(KnownShapes, an_eye_inside_of_a_solid_sees_it_at_depth_0) {
    const scene::Camera inside{{0.2, 0.1, 0.3}, {1, 1, 1}, {0, 1, 0}, 60};
    check({"sphere(1)", render_answers::ball(1), {}, inside});
    Scene scene{.formula = "sphere(1)", .bounds = {}, .camera = inside};
    for (const Pixel& pixel : traced(scene).pixels) {
        EXPECT_EQ(pixel.near, 0);
        EXPECT_EQ(pixel.far, 0);
    }
}

TEST(KnownShapes, sheets_are_cut_off_open) {
    using namespace render_answers;
    const Sheet ball_wall = zeros([](const Polynomial& x, const Polynomial& y,
                                     const Polynomial& z) { return x * x + y * y + z * z - 1.0; });
    check({"x^2 + y^2 + z^2 = 1", ball_wall});
    check({"x^2 + y^2 + z^2 = 1", ball_wall, box(0.6, 0.7, 0.8)});
    check({"(x^2 + y^2 + z^2 = 1) & (x + y <= 0.2)", ball_wall & half_space(1, 1, 0, 0.2)});
    const Sheet plane = zeros([](const Polynomial& x, const Polynomial& y, const Polynomial& z) {
        return x + y * 0.5 - z * 0.25;
    });
    check({"x + y/2 = z/4", plane});
    check({"(x^2 + y^2 + z^2 = 1) | (x + y/2 = z/4)", ball_wall | plane});
}

TEST(KnownShapes, what_lies_in_the_wall_of_the_bounds_is_within) {
    const scene::Camera off{{1, 2.6, 5.2}, {0, 0, 0}, {0, 1, 0}, 30};
    scene::Bounds wider;
    wider.half = glm::dvec3(2 + 1e-9);
    for (const char* formula : {"x^2 + y^2 + z^2 = 4", "sphere(2)", "x^2 + y^2 + z^2 <= 4"}) {
        Scene scene{.formula = formula, .bounds = {}, .camera = off};
        const Reference inner = traced(scene);
        scene.bounds = wider;
        const Reference outer = traced(scene);
        for (std::size_t i = 0; i < inner.pixels.size(); ++i) {
            EXPECT_EQ(inner.pixels[i].verdict, outer.pixels[i].verdict) << formula << " " << i;
            if (outer.pixels[i].verdict != Verdict::hit) continue;
            EXPECT_NEAR(inner.pixels[i].depth(), outer.pixels[i].depth(), 1e-9);
        }
    }
}

TEST(KnownShapes, without_bounds_rays_end_far_away) {
    using namespace render_answers;
    const scene::Bounds none{scene::Bounds::Shape::none, glm::dvec3(0), glm::dvec3(2)};
    check({"y <= -1", half_space(0, 1, 0, -1), none});
    check({"y = -1",
           zeros([](const Polynomial&, const Polynomial& y, const Polynomial&) { return y + 1.0; }),
           none});
}

}  // namespace
}  // namespace oracle
