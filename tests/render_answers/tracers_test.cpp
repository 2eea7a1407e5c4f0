// SPDX-License-Identifier: MIT
// Every tracer: those that pass no surface against known answers, all others as far as they
// promise.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <ostream>

#include <gtest/gtest.h>

#include "compile/compile.h"
#include "eval/tape.h"
#include "render_answers/agreement.h"
#include "render_answers/ray.h"

namespace render_answers {
namespace {

using P = Polynomial;

const scene::Bounds two = sphere_bounds(2);
const scene::Camera aside = camera({2.2, 1.6, 3.1});

/// Shapes whose parts are thicker than a fixed stride, but for slivers beside silhouettes.
std::vector<Answer> answers() {
    const std::string quartic = "(x^2 + y^2 + z^2 + 1 - 0.09)^2 = 4(x^2 + y^2)";
    const Sheet saddle = zeros([](const P& x, const P& y, const P& z) { return y - x * z; });
    return {
        {"sphere", {"sphere(1)", two, aside}, ball(1)},
        {"torus", {"torus(1, 0.3)", two, aside}, torus(1, 0.3)},
        {"box_in_a_box",
         {"box(0.5, 0.75, 1)", box_bounds({1.5, 0.6, 1.2}), aside},
         cuboid({0.5, 0.75, 1})},
        {"plane", {"plane(0.6, 0.8, 0, 0.2)", two, aside}, half_space(0.6, 0.8, 0, 0.2)},
        {"sphere_formula", {"x^2 + y^2 + z^2 = 1", two, aside}, boundary(ball(1))},
        {"ball_formula", {"x^2 + y^2 + z^2 <= 1", two, aside}, ball(1)},
        {"plane_formula",
         {"0.6x + 0.8y = 0.2", two, aside},
         zeros([](const P& x, const P& y, const P&) { return 0.6 * x + 0.8 * y - 0.2; })},
        {"torus_formula", {quartic, two, aside}, boundary(torus(1, 0.3))},
        {"saddle", {"y = x*z", two, aside}, saddle},
        {"exp_sphere", {"exp(x^2 + y^2 + z^2) = e", two, aside}, boundary(ball(1))},
        {"union",
         {"sphere(0.8) | x^2 + (y - 1)^2 + z^2 <= 0.49", two, aside},
         ball(0.8) | ball(0.7, {0, 1, 0})},
        {"difference",
         {"sphere(0.8) \\ (x - 0.7)^2 + (y - 0.4)^2 + (z - 0.3)^2 <= 0.49", two, aside},
         ball(0.8) & !ball(0.7, {0.7, 0.4, 0.3})},
        {"clipped_sheet", {"y = x*z & sphere(0.9)", two, aside}, saddle & ball(0.9)},
        {"eye_inside", {"x^2 + y^2 + z^2 <= 1", two, camera({0.1, 0.2, 0.3}, {1, 0, 0})}, ball(1)},
        {"eye_in_a_hollow",
         {"sphere(1.5) \\ sphere(1)", two, camera({0.1, 0.2, 0.3}, {1, 0, 0})},
         ball(1.5) & !ball(1)},
        {"without_bounds", {"x^2 + y^2 + z^2 = 1", no_bounds(), aside}, boundary(ball(1))},
        {"nothing", {"sphere(0.5) \\ sphere(1)", two, aside}, nothing()},
    };
}

struct Case {
    std::string tracer;
    Answer answer;
};

std::ostream& operator<<(std::ostream& stream, const Case& it) {
    return stream << it.tracer << ": " << it.answer;
}

std::vector<Case> cases() {
    std::vector<Case> list;
    for (const shader::TracerName& tracer : shader::tracers()) {
        for (Answer& answer : answers()) {
            answer.query.settings.tracer = tracer.name;
            answer.query.width = 64;
            answer.query.height = 48;
            list.push_back({std::string(tracer.name), std::move(answer)});
        }
    }
    return list;
}

class Tracer : public testing::TestWithParam<Case> {};

TEST_P(Tracer, finds_thick_shapes) {
    const Answer& answer = GetParam().answer;
    const Agreement agreement = compare(answer);
    EXPECT_EQ(agreement.wrong(), 0) << answer.query.formula << ": " << agreement;
    EXPECT_GT(agreement.compared, 1000);
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
    std::string name = info.param.tracer + "_" + info.param.answer.name;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Shapes, Tracer, testing::ValuesIn(cases()), name_of);

/// Where the value of f along the pixel's ray is 0 within a small part of the way.
int hits_off_the_surface(const std::string& formula, const std::string& tracer) {
    Query query{formula, sphere_bounds(3), camera({2.2, 1.6, 4.1})};
    query.settings.tracer = tracer;
    query.width = 64;
    query.height = 48;
    const auto compiled = compile::compile_formula(formula);
    EXPECT_TRUE(compiled);
    if (!compiled) return -1;
    const auto& leaf = std::get<field::Formula>(compiled->field[compiled->field.root]);
    const eval::Tape tape = eval::make_tape(compiled->field.graph, std::array{leaf.value});
    std::vector<double> registers;
    const auto value = [&](const glm::dvec3& p) {
        double result = 0;
        eval::evaluate<double>(tape, std::array{p.x, p.y, p.z}, {}, std::span(&result, 1),
                               registers);
        return result;
    };
    const render::Still still = render(query);
    int hit = 0, off = 0;
    for (int j = 0; j < query.height; ++j) {
        for (int i = 0; i < query.width; ++i) {
            if (status(still, i, j) != shader::Status::hit) continue;
            const Ray ray = ray_through(query.camera, query.width, query.height, i + 0.5, j + 0.5);
            const double t = depth(still, i, j), near = 1e-5 * t;
            const glm::dvec3 n = normal(still, i, j), p = ray.at(t);
            // On both sides of the surface, for a ray that grazes it at a tenth of a pixel as well.
            const double width = 0.2 * t * std::tan(22.5 * std::numbers::pi / 180) * 2 / 48;
            const bool crosses = (value(ray.at(t - near)) > 0) != (value(ray.at(t + near)) > 0) ||
                                 (value(p - width * n) > 0) != (value(p + width * n) > 0);
            ++hit;
            off += !crosses;
        }
    }
    EXPECT_GT(hit, 300) << formula;
    return off;
}

TEST(EveryTracer, hits_nothing_but_the_surface) {
    for (const shader::TracerName& tracer : shader::tracers()) {
        for (const char* formula : {"(x^2 + y^2 + z^2 + 0.91)^2 = 4(x^2 + y^2)",
                                    "sin(3x)*cos(3y) + sin(3y)*cos(3z) + sin(3z)*cos(3x) = 0",
                                    "tan(x) = y*z", "x^2 + y^2 - 0.3z = 0.1sin(40z)"}) {
            EXPECT_EQ(hits_off_the_surface(formula, std::string(tracer.name)), 0)
                << formula << ", " << tracer.name;
        }
    }
}

TEST(Relaxed, hits_where_sphere_tracing_does) {
    for (const char* formula :
         {"(x^2 + y^2 + z^2 + 0.91)^2 = 4(x^2 + y^2)",
          "sin(3x)*cos(3y) + sin(3y)*cos(3z) + sin(3z)*cos(3x) = 0",
          "repeat(rotate(box(0.4, 0.1, 0.2), (1, 2, 3), 50), (1, 0.8, 0.7))", "menger(3)",
          "smooth_union(repeat(x^2 + 3y^2 + z^4 <= 0.1, (1, 1, 1)), sphere(0.8), 0.2)"}) {
        Query query{formula, two, aside};
        query.width = 64;
        query.height = 48;
        query.settings.steps = 4000;
        query.settings.epsilon = 0.001;
        query.settings.tracer = "sphere";
        const render::Still sphere = render(query);
        query.settings.tracer = "relaxed";
        const render::Still relaxed = render(query);
        int different = 0, moved = 0;
        for (int j = 0; j < query.height; ++j) {
            for (int i = 0; i < query.width; ++i) {
                different += status(sphere, i, j) != status(relaxed, i, j);
                moved += std::abs(depth(sphere, i, j) - depth(relaxed, i, j)) > 0.01;
            }
        }
        // A ray that comes closer than a thousandth of a pixel may end there or not.
        EXPECT_LE(different, 1) << formula;
        EXPECT_LE(moved, 1) << formula;
    }
}

}  // namespace
}  // namespace render_answers
